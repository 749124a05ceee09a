# Says in words why a build failed: awk -v mine=FILE -v own=COMMAND -f compiler_words.awk compiler_words.tsv LOG.
# It shows the first error of g++ or clang++, the line of the student's file that led to it, and one sentence.
# `mine` is that file; without it any chapter's file is. `own` shows all that the compiler said. Status 1, and
# nothing said, if no error of the log has to do with such a file.

# Sets at, row, column to the place that a line begins with, if it is in a student's file and none is set.
function take_place(text,  number) {
  if (at != "" || !match(text, /chapters\/[0-9][0-9]_[^:]*:[0-9]+:[0-9]+:/)) return
  text = substr(text, RSTART)
  split(text, number, ":")
  if (mine != "" && number[1] != mine) return
  at = number[1]
  row = number[2]
  column = number[3]
}

# Types and names as a student writes them: Vec3 for using Vec3 = struct texmap::Vec3<double>.
function short(text) {
  gsub(/`/, "'", text)
  gsub(/ [{(]aka '[^']*'[})]/, "", text)
  gsub(/texmap::|using [A-Za-z0-9]+ = |struct |class |const | *&/, "", text)
  gsub(/Vec3<(double|float|Real)>/, "Vec3", text)
  gsub(/Color<(double|float|Real)>/, "Color", text)
  gsub(/Uv<(double|float|Real)>/, "Uv", text)
  return text
}

# Sets said[name] to what matches in the text, without so much at its ends; tells whether it does.
function take(name, text, pattern, left, right) {
  if (said[name] != "" || !match(text, pattern)) return 0
  said[name] = substr(text, RSTART + left, RLENGTH - left - right)
  return 1
}

# The same for the two quoted words of what matches.
function take_two(first, second, text, pattern,  quoted) {
  if (!match(text, pattern)) return
  split(substr(text, RSTART, RLENGTH), quoted, "'")
  if (said[first] != "") return
  said[first] = quoted[2]
  said[second] = quoted[4]
}

function step_back() {
  line = before
  row = row_before
}

# Reads the student's line, the statement that begins there, and the last line before it that has code.
function read_lines(  text, i) {
  for (i = 1; (getline text < at) > 0; i++) {
    if (row == "" && index(text, said["called"])) row = i
    if (i == row) line = text
    if (row == "" || i < row) {
      if (text ~ /^ *(\/\/.*)?$/) continue
      before = text
      row_before = i
    } else if (i < row + 6 && statement !~ /;/) {
      sub(/ *\/\/.*/, "", text)
      statement = statement text
    }
  }
  if (row == "") step_back()
}

# What the statement calls, and which arguments are whole numbers among those of the type `real`.
function read_call(real,  rest, i, c, depth, one, count, others, whole, written) {
  c = said["called"] ~ /^(max|min|clamp)$/ ? said["called"] : "std::[a-z_]+"
  if (!take("call", statement, c "[(]", 0, 1)) return
  rest = substr(statement, RSTART + RLENGTH)
  sub(/^std::/, "", said["call"])
  for (i = 1; i <= length(rest) && depth >= 0; i++) {
    c = substr(rest, i, 1)
    depth += (c ~ /[({[]/) - (c ~ /[])}]/)
    if (depth > 0 || (depth == 0 && c != ",")) {
      one = one c
      continue
    }
    gsub(/^ +| +$/, "", one)
    if (one !~ /^-?[0-9]+$/) {
      others = others (others == "" ? "" : " and ") one
    } else {
      whole = whole (count++ ? " and " : "") one
      written = written (written == "" ? "" : " and ") (at ~ /lesson/ ? "Real(" one ")" : one ".0")
    }
    one = ""
  }
  if (count && others != "" && real != "int")
    said["literals"] = whole (count > 1 ? " are ints" : " is an int") " and " others " a " real ": write " written
}

# Finds all that a sentence may name.
function understand(  notes, quoted, n, i, header) {
  notes = short(block)
  said["static"] = message
  message = short(message)
  n = split(message, quoted, "'")
  for (i = 2; i <= n; i += 2)
    if (quoted[i] !~ /^operator/) said[++count] = quoted[i]
  sub(/^::/, "", said[1])
  said["called"] = said[1]
  sub(/[(].*/, "", said["called"])
  read_lines()
  if (message ~ /^no match for 'operator|^invalid operands/) {
    if (!take("op", message, "'operator[^']+'", 9, 1))
      take("op", substr(line, column), "^[-+*/%^=!<>&|]+", 0, 0)
    message = "operands " said["op"] " '" said[1] "' '" said[2] "'"
  }
  gsub(/`/, "'", said["static"])
  sub(/^static.assert(ion)? failed( due to requirement '[^']*')?[: ]*/, "", said["static"])
  take_two("from", "to", notes, "(from|convert|conversion of|assigned) [a-z ]*'[^']*' to [a-z -]*'[^']*'")
  take_two("to", "from", notes, "type '[^']*' (from expression|with an? [a-z]+|could not bind to an? [a-z]+) of type '[^']*'")
  take("counts", notes, "(expects|requires) [^,\n]*, [^\n]*provided", 0, 0)
  take("better", message, "did you mean '[^']*'", 14, 1)
  take("name", line, "[A-Za-z_][A-Za-z_0-9.]*(\\[[^]]*\\])?( *[-+*/]?=[^=]|\\.[a-z_]+[(]|\\+\\+|--)", 0, 0)
  sub(/( *[-+*\/]?=.|\.[a-z_]+[(]|\+\+|--)$/, "", said["name"])
  take("member", message, "member named '[^']*'", 14, 1)
  said["owner"] = said[1] == said["member"] ? said[2] : said[1]
  said["real"] = notes ~ /'float'/ ? "float" : notes ~ /'double'/ ? "double" : "int"
  read_call(said["real"])
  block = notes "\n" statement "\n" inside
}

# The sentence of the first row that fits; else the compiler's message.
function sentence(  i, rest, words, name) {
  for (i = 1; i <= rows; i++) {
    if (message !~ of_message[i] || block !~ of_notes[i]) continue
    for (rest = of_words[i]; match(rest, /[{][a-z0-9]+[}]/); rest = substr(rest, RSTART + RLENGTH)) {
      name = substr(rest, RSTART + 1, RLENGTH - 2)
      if (said[name] == "") break
      words = words substr(rest, 1, RSTART - 1) said[name]
    }
    if (rest !~ /[{][a-z0-9]+[}]/) return words rest
    words = ""
  }
  return "the compiler says: " substr(message, 1, 300)
}

NR == FNR {
  split($0, cell, "\t")
  if (/^#/) next
  of_message[++rows] = cell[1]
  of_notes[rows] = cell[2]
  of_words[rows] = cell[3]
  next
}

# The first error, or the first of a static_assert. g++ says before it, and clang++ after it, what led to it.
/(^|: )(fatal )?error: |: undefined reference to |: multiple definition of / && !/ld returned|linker command/ {
  is_read = !errors++ || (/static.assert(ion)? failed/ && message !~ /static.assert/)
  if (is_read) {
    at = row = block = ""
    take_place($0)
    inside = at != "" ? "" : /exercise_[0-9_]*\.cpp/ ? "outside" : "inside"
    take_place(led)
    message = $0
    sub(/; .*: first defined here$/, "", message)
    sub(/^.*(error|:[^ ]*[)]): /, "", message)
  }
}
is_read { block = block "\n" $0 }
is_read && /requested here/ || inside == "outside" && /to match this/ { take_place($0) }
/: +required (from|by)/ && /chapters\/[0-9][0-9]_/ && led == "" { led = $0 }
/: In (instantiation|substitution) of / { led = "" }

END {
  if (at == "" && inside == "outside") at = mine
  if (!errors || at == "") exit 1
  understand()
  if (message ~ /expected .*';'/ && substr(line, 1, column - 1) ~ /^ *$/) step_back()
  sub(/^ +/, "", line)
  print at ":" row ":\n    " line "\n  " sentence()
  print "  (" (errors > 1 ? "the first of " errors " errors; " : "") "the compiler's own text: " own ")"
}
