package org.mechservice.benchmarks.peer;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The derivative of a generated class as C: the same statements, put into the other language by
 * replacing words. What the workspace is in the class is a static array in C.
 */
final class CText {
  private static final Pattern WORKSPACE = Pattern.compile("w = new double\\[(\\d+)]");
  private static final Pattern METHOD =
      Pattern.compile(
          "^  (public|private static) (int|void) (derivative\\d*)\\(.*?\\n  }\\n",
          Pattern.MULTILINE | Pattern.DOTALL);

  private CText() {}

  /**
   * Returns the C text of {@code int derivative(double t, double *y, double *yDot)}.
   *
   * @param source a generated class
   * @param states length of the state
   */
  static String of(String source, int states) {
    Matcher workspace = WORKSPACE.matcher(source);
    String slots = workspace.find() ? workspace.group(1) : "1";
    StringBuilder parts = new StringBuilder();
    String whole = "";
    Matcher method = METHOD.matcher(source);
    while (method.find()) {
      String text = translated(method.group());
      if (method.group(3).equals("derivative")) {
        whole = text.replace("double *w = this.w;", "static double w[" + slots + "];");
      } else {
        parts.append("__attribute__((noinline)) ").append(text).append('\n');
      }
    }
    return "#define STATES " + states + "\n" + parts + whole;
  }

  private static String translated(String method) {
    return method
        .strip()
        .replaceAll("^public |^private ", "")
        .replace("double[] ", "double *")
        .replace("SinCos.sinCos(", "sinCos(")
        .replace("Math.sqrt(", "sqrt(")
        .replaceAll(
            "System\\.arraycopy\\((\\w+), (\\d+), (\\w+), (\\d+), (\\d+)\\)",
            "memcpy($3 + $4, $1 + $2, $5 * sizeof(double))");
  }
}
