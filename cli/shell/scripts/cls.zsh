#compdef cls
# zsh completion of cls. Asks the program that the line names. In a folder of $fpath its name is _cls.
_cls() {
  local line paths prefix
  local -a reply texts notes open_texts open_notes
  reply=("${(@f)$(command ${(Q)words[1]/#\~/$HOME} complete -- \
    "${(@Q)words[2,CURRENT-1]}" "${(Q)PREFIX}" 2>/dev/null)}")
  for line in $reply; do
    local text=${line%%$'\t'*} note=''
    [[ $line == *$'\t'* ]] && note=${line#*$'\t'}
    local shown=$text${note:+"  -- $note"}
    case $line in
      :*) paths=$text prefix=$note ;;
      *[=:/]$'\t'*) open_texts+=("$text") open_notes+=("$shown") ;;
      *) texts+=("$text") notes+=("$shown") ;;
    esac
  done
  local found=1
  (( $#texts )) && compadd -l -d notes -a texts && found=0
  (( $#open_texts )) && compadd -S '' -l -d open_notes -a open_texts && found=0
  if [[ -n $paths ]]; then
    [[ -n $prefix ]] && compset -P "${(q)prefix}"
    if [[ $paths == :folders ]]; then _files -/ && found=0; else _files && found=0; fi
  fi
  return found
}
if [[ $zsh_eval_context[-1] == loadautofunc ]]; then _cls "$@"; else compdef _cls cls; fi
