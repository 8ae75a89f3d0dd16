// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/build.h"

#include <elf.h>
#include <link.h>

#include <cstring>
#include <span>

#include "certificate/sha256.h"
#include "cli/outputs.h"

// The linker leaves a hash of the program in it, as a note. The libraries that are loaded
// beside it are told by their versions.

namespace seam::cli {
namespace {

std::size_t padded(std::size_t size) {
  return (size + 3) / 4 * 4;
}

std::string hash_among(std::span<const char> notes) {
  ElfW(Nhdr) head;
  while (notes.size() >= sizeof head) {
    std::memcpy(&head, notes.data(), sizeof head);
    const std::size_t name = sizeof head, text = name + padded(head.n_namesz),
                      end = text + padded(head.n_descsz);
    if (end > notes.size()) break;
    if (head.n_type == NT_GNU_BUILD_ID && head.n_namesz == 4 &&
        std::memcmp(notes.data() + name, "GNU", 4) == 0)
      return {notes.data() + text, head.n_descsz};
    notes = notes.subspan(end);
  }
  return {};
}

// Of the first object, which is the program.
int find_hash(dl_phdr_info* object, std::size_t, void* found) {
  for (std::size_t i = 0; i < object->dlpi_phnum; ++i) {
    const auto& part = object->dlpi_phdr[i];
    if (part.p_type != PT_NOTE) continue;
    const auto* begin = reinterpret_cast<const char*>(object->dlpi_addr + part.p_vaddr);
    std::string hash = hash_among({begin, part.p_memsz});
    if (!hash.empty()) *static_cast<std::string*>(found) = std::move(hash);
  }
  return 1;
}

}  // namespace

std::string build_name() {
  std::string all;
  dl_iterate_phdr(find_hash, &all);
  all += tool_name();
  for (const std::string& library : libraries()) all += "\n" + library;
  return certificate::sha256(all).substr(0, 16);
}

}  // namespace seam::cli
