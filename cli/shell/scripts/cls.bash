# bash completion of cls. Asks the program that the line names: source <(cls completion bash)
_cls() {
  # Bash splits words at ':' and '='; cls needs them whole.
  local rest=${COMP_LINE:0:COMP_POINT} piece i
  local -a words=()
  for ((i = 0; i <= COMP_CWORD; i++)); do
    piece=${COMP_WORDS[i]}
    if [[ $i == 0 || $rest == [[:space:]]* ]]; then
      rest=${rest#"${rest%%[![:space:]]*}"}
      words+=('')
    fi
    [[ $rest == "$piece"* ]] || piece=$rest
    words[-1]+=$piece
    rest=${rest#"$piece"}
  done
  local word=${words[-1]} done_part=''
  # Bash replaces only what follows the last separator.
  local separators=${COMP_WORDBREAKS//[^:=]/}
  if [[ $separators && $word == *["$separators"]* ]]; then
    done_part=${word%"${word##*["$separators"]}"}
  fi

  local line paths='' prefix=''
  COMPREPLY=()
  while IFS= read -r line; do
    case $line in
      :*) IFS=$'\t' read -r paths prefix <<<"$line" ;;
      *) line=${line%%$'\t'*}; COMPREPLY+=("${line#"$done_part"}") ;;
    esac
  done < <(command "${words[0]/#\~/$HOME}" complete -- "${words[@]:1}" 2>/dev/null)

  if [[ ${#COMPREPLY[@]} == 1 && ${COMPREPLY[0]} == *[=:/] ]]; then
    compopt -o nospace
  fi
  if [[ $paths ]]; then
    compopt -o filenames 2>/dev/null
    local kind=f path=${word#"$prefix"}
    [[ $paths == :folders ]] && kind=d
    while IFS= read -r line; do
      line=$prefix$line
      COMPREPLY+=("${line#"$done_part"}")
    done < <(compgen -"$kind" -- "$path")
  fi
}
complete -F _cls cls
