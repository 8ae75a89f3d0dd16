// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/style.h"

// \SeamFormula prints a formula as wide as it is if it fits the line. If not, it is set as a
// paragraph that may break at relations, at sums and after commas; the lines of a trial setting
// are measured, and where a piece that cannot be broken is still too wide, the whole is scaled
// down until it fits. So nothing runs off the page.

namespace seam::report {

const std::string_view style = R"(\documentclass[10pt,a4paper]{article}
\pdfinfoomitdate=1 \pdfsuppressptexinfo=-1 \pdftrailerid{}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{lmodern,textcomp,amsmath,amssymb,graphicx,xcolor,booktabs,longtable,array,tikz}
\usepackage[a4paper,hmargin=24mm,top=22mm,bottom=25mm]{geometry}
\usepackage[protrusion=true,expansion=false]{microtype}
\usepackage{fancyhdr}
\usepackage[hidelinks,bookmarksnumbered=false,pdfusetitle]{hyperref}

% Colours that stay apart for every kind of colour blindness, dark enough to be read on white.
\definecolor{proven}{HTML}{00694D}
\definecolor{refuted}{HTML}{A83C00}
\definecolor{conditional}{HTML}{005A96}
\definecolor{undecided}{HTML}{6B5900}
\colorlet{quiet}{black!62}

\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt plus 1pt}
\setlength{\emergencystretch}{3em}
\setcounter{secnumdepth}{0}
\setcounter{tocdepth}{1}
\pagestyle{fancy}
\fancyhf{}
\renewcommand{\headrulewidth}{0pt}
\fancyfoot[C]{\small\thepage}
\fancyfoot[L]{\footnotesize\color{quiet}\SeamRunning}
\newcommand{\SeamRunning}{}

% A mark for each verdict: a shape, never a colour alone.
\newcommand{\SeamShape}[2]{\tikz[baseline=-0.6ex,line width=1.2pt,line cap=round,line join=round,draw=#1,fill=#1]{#2}}
\newcommand{\SeamMarkproven}{\SeamShape{proven}{\draw (-0.11,0) -- (-0.03,-0.09) -- (0.12,0.11);}}
\newcommand{\SeamMarkrefuted}{\SeamShape{refuted}{\draw (-0.09,-0.09) -- (0.09,0.09) (-0.09,0.09) -- (0.09,-0.09);}}
\newcommand{\SeamMarkconditional}{\SeamShape{conditional}{\draw (0,0) circle (0.1); \fill (0,-0.1) arc (-90:90:0.1) -- cycle;}}
\newcommand{\SeamMarkundecided}{\SeamShape{undecided}{\node[inner sep=0pt,undecided,font=\bfseries\sffamily] at (0,0) {?};}}
\newcommand{\SeamMark}[1]{\makebox[1.1em][c]{\csname SeamMark#1\endcsname}}
\newcommand{\SeamVerdict}[1]{\textcolor{#1}{\SeamMark{#1}\,\textsf{\textbf{#1}}}}

% Formulas.
\newsavebox{\SeamBox}
\newdimen{\SeamWidest}
\mathchardef\SeamComma="613B
{\catcode`\,=\active \gdef,{\SeamComma\penalty50 }}
\newcommand{\SeamMathematics}{\relpenalty=10 \binoppenalty=200 \lineskiplimit=3pt \lineskip=4pt
  \hbadness=10000 \hfuzz=\maxdimen \mathcode`\,="8000 }
\newcommand{\SeamParagraph}[2]{\hsize=#1\relax \linewidth=#1\relax \raggedright \noindent $\displaystyle #2$\par}
\newcommand{\SeamMeasure}{%
  \setbox0\lastbox
  \ifvoid0 \else
    \setbox0\hbox{\unhbox0}%
    \ifdim\wd0>\SeamWidest \global\SeamWidest=\wd0 \fi
    \unskip\unpenalty\unskip\unpenalty
    \expandafter\SeamMeasure
  \fi}
\newcommand{\SeamFormula}[2][\linewidth]{{\par\SeamMathematics
  \sbox{\SeamBox}{$\displaystyle #2$}%
  \dimen2=#1\relax
  \ifdim\wd\SeamBox>\dimen2
    \global\SeamWidest=0pt
    \setbox2\vbox{\SeamParagraph{\dimen2}{#2}\SeamMeasure}%
    \ifdim\SeamWidest>\dimexpr\dimen2+0.5pt\relax
      \sbox{\SeamBox}{\vbox{\SeamParagraph{\SeamWidest}{#2}}}%
      \sbox{\SeamBox}{\resizebox{\dimen2}{!}{\usebox{\SeamBox}}}%
      \ifdim\dimexpr\ht\SeamBox+\dp\SeamBox\relax>0.85\textheight
        \sbox{\SeamBox}{\resizebox{!}{0.85\textheight}{\usebox{\SeamBox}}}%
      \fi
      \noindent\usebox{\SeamBox}\par
    \else
      \raggedright\noindent $\displaystyle #2$\par
    \fi
  \else
    \noindent\usebox{\SeamBox}\par
  \fi}}
\newenvironment{SeamIndent}{\list{}{\leftmargin=1.6em \rightmargin=0pt \topsep=3pt \partopsep=0pt
  \parsep=3pt \itemsep=0pt \listparindent=0pt}\item\relax}{\endlist}

% A claim: a band with its mark, id, title, place and verdict; then its body.
\newcommand{\SeamBand}[3]{\par\addvspace{11pt plus 4pt}\penalty-200 {\fboxsep=3.5pt
  \colorbox{#1!9}{\parbox{\dimexpr\linewidth-2\fboxsep\relax}{%
    \parbox[t]{\dimexpr\linewidth-8.2em\relax}{\raggedright #2\strut}\hfill
    \makebox[7.8em][r]{#3}}}\par}\nobreak}
\newcommand{\SeamClaim}[5]{\SeamBand{#1}{\leavevmode\hypertarget{#2}{}\texttt{\textbf{#3}}%
  \if\relax\detokenize{#4}\relax\else\quad #4\fi
  \if\relax\detokenize{#5}\relax\else\quad\textcolor{quiet}{#5}\fi}{\SeamVerdict{#1}}}
\newcommand{\SeamQuestion}[2]{\SeamBand{black}{\texttt{\textbf{#1}}}{\textcolor{quiet}{\textsf{#2}}}}
\newcommand{\SeamNote}[1]{{\small\itshape\raggedright #1\par}\nobreak}
\newcommand{\SeamSource}[1]{{\footnotesize\ttfamily\raggedright #1\par}}
\newcommand{\SeamLine}[2]{{\raggedright\textcolor{quiet}{#1}\ \ #2\par}}
\newcommand{\SeamAlarm}[1]{{\raggedright\textcolor{refuted}{\textbf{Soundness alarm.} #1}\par}}
\newcommand{\SeamTrace}[1]{{\footnotesize\color{quiet}\raggedright #1\par}}

\newenvironment{SeamTally}{\small\begin{longtable}{@{}>{\raggedright\arraybackslash}p{0.33\linewidth}*{6}{r}@{}}\toprule
  & claims & \SeamMark{proven} proven & \SeamMark{refuted} refuted & \SeamMark{conditional} cond.
  & \SeamMark{undecided} undec. & as expected\\ \midrule\endhead}{\bottomrule\end{longtable}}

% What a claim was turned into.
\newcommand{\SeamMarkholds}{\SeamMarkproven}
\newcommand{\SeamMarkfails}{\SeamMarkrefuted}
\newcommand{\SeamMarkopen}{\SeamMarkundecided}
\newenvironment{SeamObligations}{\par\small\textcolor{quiet}{turned into}\nobreak
  \list{}{\leftmargin=2.2em \labelwidth=1.2em \labelsep=0.5em \topsep=1pt \partopsep=0pt \parsep=1pt
  \itemsep=2pt \listparindent=0pt \raggedright}}{\endlist}
\newcommand{\SeamObligation}[3]{\item[\SeamMark{#1}] #2%
  \if\relax\detokenize{#3}\relax\else\ \ \textcolor{quiet}{[\,#3\,]}\fi\par}
)";

}  // namespace seam::report
