package org.mechservice.sim.emit.c;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.ParameterSlots;
import org.mechservice.sim.emit.source.Syntax;
import org.mechservice.solver.symbol.MathFunction;

/** Programs as functions of C99, which take the instance of the model as their first parameter. */
final class CSyntax implements Syntax {
  /** Prefix of the elementary functions of {@code mech_math.h}. */
  private static final String PREFIX = "mech_";

  /** Keywords and macros of C that are no keywords of Java, and names that the functions use. */
  private static final Set<String> RESERVED =
      Set.of(
          "EDOM",
          "EOF",
          "ERANGE",
          "FP_FAST_FMA",
          "HUGE_VAL",
          "INFINITY",
          "NAN",
          "NULL",
          "REGULAR",
          "auto",
          "const",
          "dx",
          "errno",
          "extern",
          "g",
          "given",
          "goto",
          "inline",
          "m",
          "memcpy",
          "memset",
          "register",
          "restrict",
          "seed",
          "signbit",
          "signed",
          "sizeof",
          "sqrt",
          "struct",
          "typedef",
          "union",
          "unsigned",
          "u",
          "values",
          "x");

  private static final Pattern COMMENT = Pattern.compile("//[^\n]*");

  private final String type;

  /**
   * @param type name of the type of the model's instances
   */
  CSyntax(String type) {
    this.type = type;
  }

  @Override
  public String array(String name, boolean isWritten) {
    return (isWritten ? "double *" : "const double *") + name;
  }

  @Override
  public String head(String modifiers, String result, String name, List<String> parameters) {
    List<String> all = new ArrayList<>(List.of(type + " *" + receiver()));
    all.addAll(parameters);
    return part(result, name, all);
  }

  @Override
  public String part(String result, String name, List<String> parameters) {
    return "static " + result + " " + name + "(" + String.join(", ", parameters) + ")";
  }

  @Override
  public String receiver() {
    return "m";
  }

  @Override
  public String field(String name) {
    if (name.equals(ConstantTable.NAME)) {
      return "const double *" + name + " = " + ConstantTable.FIELD + ";";
    }
    return array(name, name.equals(ParameterSlots.WORKSPACE)) + " = m->" + name + ";";
  }

  @Override
  public String sinCos(String angle, String slot) {
    return PREFIX + "sin_cos(" + angle + ", w + " + slot + ");";
  }

  @Override
  public String copy(String from, int fromAt, String to, int toAt, int count) {
    return "memcpy(%s + %d, %s + %d, %d * sizeof(double));"
        .formatted(to, toAt, from, fromAt, count);
  }

  @Override
  public String squareRoot(String value) {
    return "sqrt(" + value + ")";
  }

  @Override
  public String row(int first, int count) {
    return ConstantTable.FIELD + " + " + first + ", " + count;
  }

  @Override
  public String function(MathFunction function) {
    return PREFIX + function.cName();
  }

  @Override
  public Set<String> reserved() {
    return RESERVED;
  }

  @Override
  public List<String> unused(List<String> names, String body) {
    String code = COMMENT.matcher(body).replaceAll("");
    return names.stream()
        .filter(name -> !Pattern.compile("\\b" + name + "\\b").matcher(code).find())
        .map(name -> "(void)" + name + ";")
        .toList();
  }
}
