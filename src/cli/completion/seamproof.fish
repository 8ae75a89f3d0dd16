# SPDX-License-Identifier: GPL-3.0-or-later
# Completion for fish: the program itself says what may follow.

function __seamproof_complete
    set -l before (commandline --tokenize --cut-at-cursor --current-process)
    set -l program $before[1]
    set -e before[1]
    set -l last (commandline --current-token --cut-at-cursor)
    set -l name
    if string match --quiet -- '--*=*' $last
        set name (string replace --regex -- '=.*' '=' $last)
        set before $before (string replace -- '=' '' $name)
        set last (string replace --regex -- '^[^=]*=' '' $last)
    end
    for line in ($program complete $before "$last" 2>/dev/null)
        switch $line
            case /
                printf "$name%s\n" (__fish_complete_directories "$last")
            case '/\*.*'
                set -l ending '(?:/|'(string escape --style=regex -- (string sub --start 3 -- $line))')\t'
                printf "$name%s\n" (__fish_complete_path "$last" | string match --entire --regex -- $ending)
            case '/*'
                printf "$name%s\n" (__fish_complete_path "$last")
            case '*'
                printf "$name%s\n" $line
        end
    end
end

complete --command seamproof --no-files --arguments '(__seamproof_complete)'
