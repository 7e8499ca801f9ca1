package org.mechservice.sim.emit.source;

import java.util.List;
import java.util.Set;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.solver.symbol.MathFunction;

/** Programs as methods of a Java class. */
final class JavaSyntax implements Syntax {
  @Override
  public String array(String name, boolean isWritten) {
    return "double[] " + name;
  }

  @Override
  public String head(String modifiers, String result, String name, List<String> parameters) {
    return modifiers + " " + signature(result, name, parameters);
  }

  @Override
  public String part(String result, String name, List<String> parameters) {
    return "private static " + signature(result, name, parameters);
  }

  private static String signature(String result, String name, List<String> parameters) {
    return result + " " + name + "(" + String.join(", ", parameters) + ")";
  }

  @Override
  public String receiver() {
    return "this";
  }

  @Override
  public String field(String name) {
    boolean ofClass = name.equals(ConstantTable.NAME);
    return "double[] " + name + " = " + (ofClass ? ConstantTable.FIELD : "this." + name) + ";";
  }

  @Override
  public String sinCos(String angle, String slot) {
    return "SinCos.sinCos(" + angle + ", w, " + slot + ");";
  }

  @Override
  public String copy(String from, int fromAt, String to, int toAt, int count) {
    return "System.arraycopy(%s, %d, %s, %d, %d);".formatted(from, fromAt, to, toAt, count);
  }

  @Override
  public String squareRoot(String value) {
    return "Math.sqrt(" + value + ")";
  }

  @Override
  public String row(int first, int count) {
    return ConstantTable.FIELD + ", " + first + ", " + count;
  }

  @Override
  public String function(MathFunction function) {
    String owner = function.owner();
    return owner.substring(owner.lastIndexOf('/') + 1) + "." + function.method();
  }

  @Override
  public Set<String> reserved() {
    return Set.of();
  }

  @Override
  public List<String> unused(List<String> names, String body) {
    return List.of();
  }
}
