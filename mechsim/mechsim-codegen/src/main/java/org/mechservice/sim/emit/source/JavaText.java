package org.mechservice.sim.emit.source;

import java.util.List;
import java.util.Set;
import javax.lang.model.SourceVersion;
import org.mechservice.sim.emit.method.TextPieces;
import org.mechservice.solver.links.Labels;

/**
 * Text from model files inside Java source. Names are untrusted input: any name stays text inside a
 * literal, and no name can end a comment.
 */
public final class JavaText {
  /** Simple names the generated source uses, or that are imported everywhere. */
  private static final Set<String> TAKEN =
      Set.of(
          "Accuracy",
          "ArrayList",
          "Arrays",
          "BodyPoses",
          "ColumnGroup",
          "CubicCurve",
          "DirectedForces",
          "Energies",
          "ExplicitModel",
          "List",
          "LoopTerms",
          "Model",
          "ModelDescription",
          "Double",
          "Math",
          "NumberTable",
          "Object",
          "Override",
          "PowerInput",
          "ResidualModel",
          "ResultColumns",
          "RunSettings",
          "SinCos",
          "StrictMath",
          "Piecewise",
          "Powers",
          "String",
          "System",
          "TreeStepModel",
          "Variable",
          "WrittenFormulas",
          "WrittenValues",
          "De",
          "Ode113",
          "Integrator",
          "IntegratorFactory",
          "IntegratorSettings",
          "Standalone");

  private static final int LONGEST_LITERAL = 70;

  private JavaText() {}

  /** Returns a class name for a model name: ASCII letters, digits and underscores. */
  public static String className(String modelName) {
    String name = Labels.sanitized(modelName);
    if (!Character.isJavaIdentifierStart(name.charAt(0))) {
      name = "Model" + name;
    }
    return TAKEN.contains(name) || SourceVersion.isKeyword(name) || isOnlyUnderscores(name)
        ? "Model" + name
        : name;
  }

  private static boolean isOnlyUnderscores(String name) {
    for (int i = 0; i < name.length(); i++) {
      if (name.charAt(i) != '_') {
        return false;
      }
    }
    return true;
  }

  /**
   * Returns an expression for a text, in ASCII: literals, which the compiler joins to a constant,
   * and the run to longer texts.
   */
  public static String literal(String text) {
    List<String> pieces = TextPieces.of(text);
    StringBuilder joined = new StringBuilder(constant(pieces.get(0)));
    if (pieces.size() > 1) {
      joined.insert(0, '(').append(')');
    }
    for (String piece : pieces.subList(1, pieces.size())) {
      joined.append(".concat(").append(constant(piece)).append(')');
    }
    return joined.toString();
  }

  private static String constant(String text) {
    StringBuilder literal = new StringBuilder("\"");
    int lineStart = 0;
    for (int i = 0; i < text.length(); i++) {
      if (literal.length() - lineStart > LONGEST_LITERAL) {
        literal.append("\" + \"");
        lineStart = literal.length();
      }
      char c = text.charAt(i);
      switch (c) {
        case '"' -> literal.append("\\\"");
        case '\\' -> literal.append("\\\\");
        case '\n' -> literal.append("\\n");
        case '\r' -> literal.append("\\r");
        case '\t' -> literal.append("\\t");
        default -> append(literal, c);
      }
    }
    return literal.append('"').toString();
  }

  private static void append(StringBuilder literal, char c) {
    if (c >= ' ' && c <= '~') {
      literal.append(c);
    } else {
      literal.append("\\u");
      String hex = Integer.toHexString(c);
      literal.append("0".repeat(4 - hex.length())).append(hex);
    }
  }

  /**
   * Returns text for a comment: what could end the comment, start a Unicode escape or markup, or is
   * not plain ASCII becomes {@code ?}; line feeds stay.
   */
  public static String comment(String text) {
    StringBuilder comment = new StringBuilder();
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      boolean ends = c == '/' && i > 0 && text.charAt(i - 1) == '*';
      boolean plain = c >= ' ' && c <= '~' && "\\<>&@{}".indexOf(c) < 0;
      comment.append(c == '\n' || (plain && !ends) ? c : '?');
    }
    return comment.toString();
  }
}
