package org.mechservice.sim.emit.source;

/** Builds source code: indented, at most 100 columns wide. */
public final class SourceLines {
  private static final int WIDTH = 100;
  private static final int CONTINUATION = 4;

  private final StringBuilder text = new StringBuilder();
  private int indentation;

  /** Returns empty lines of the same indentation, to be appended later. */
  public SourceLines sameIndentation() {
    SourceLines lines = new SourceLines();
    lines.indentation = indentation;
    return lines;
  }

  /** Appends lines. */
  public SourceLines append(SourceLines lines) {
    text.append(lines.text);
    return this;
  }

  /** Opens a block: writes a line and indents the lines after it. */
  public SourceLines open(String line) {
    line(line + " {");
    indentation += 2;
    return this;
  }

  /** Closes a block. */
  public SourceLines close() {
    indentation -= 2;
    return line("}");
  }

  /** Closes a block that is an expression of a statement. */
  public SourceLines closeStatement() {
    indentation -= 2;
    return line("};");
  }

  /** Writes an empty line. */
  public SourceLines blank() {
    text.append('\n');
    return this;
  }

  /** Writes a line. A line that is too long is broken before an operator. */
  public SourceLines line(String line) {
    fill(line, "", CONTINUATION);
    return this;
  }

  /** Writes a comment, one line of it for every line of text, wrapped where too long. */
  public SourceLines comment(String comment) {
    for (String line : comment.split("\n", -1)) {
      fill("// " + line, "// ", 0);
    }
    return this;
  }

  /** Writes the lines of a documentation comment. */
  public SourceLines documentation(Iterable<String> lines) {
    line("/**");
    for (String line : lines) {
      if (line.isEmpty()) {
        line(" *");
      } else {
        fill(" * " + line, " * ", 0);
      }
    }
    return line(" */");
  }

  private void fill(String line, String prefix, int continuation) {
    String rest = line;
    int indent = indentation;
    while (indent + rest.length() > WIDTH) {
      int end = breakBefore(rest, WIDTH - indent, prefix.isEmpty());
      if (end <= prefix.length()) {
        break;
      }
      text.append(" ".repeat(indent)).append(rest, 0, end).append('\n');
      rest = prefix + rest.substring(end + 1);
      indent = indentation + continuation;
    }
    text.append(" ".repeat(indent)).append(rest).append('\n');
  }

  /**
   * Returns the last blank, not beyond {@code limit}, at which a line may be broken; in code those
   * before a plus or minus are preferred, and none inside a string literal counts.
   */
  private static int breakBefore(String line, int limit, boolean code) {
    int best = 0;
    int bestSum = 0;
    boolean inString = false;
    boolean escaped = false;
    for (int i = 0; i < Math.min(line.length() - 1, limit + 1); i++) {
      char c = line.charAt(i);
      inString ^= code && c == '"' && !escaped;
      escaped = c == '\\' && !escaped;
      if (c == ' ' && !inString && !line.substring(0, i).isBlank()) {
        char next = line.charAt(i + 1);
        boolean operand = code && "+-*/=".indexOf(line.charAt(i - 1)) >= 0;
        best = operand ? best : i;
        bestSum = code && (next == '+' || next == '-') && !operand ? i : bestSum;
      }
    }
    return bestSum > limit / 2 ? bestSum : best;
  }

  @Override
  public String toString() {
    return text.toString();
  }
}
