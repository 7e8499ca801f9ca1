package org.mechservice.sim.emit.method;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import org.mechservice.solver.text.ShortestDecimal;

/** Numbers as Java literals of type double: the fewest digits that read back exactly. */
public final class NumberText {
  /** No double takes more characters than sign, 17 digits, point, zeros, and exponent. */
  private static final int LONGEST = 32;

  private final ShortestDecimal shortest = new ShortestDecimal();
  private final byte[] buffer = new byte[LONGEST];
  private final Map<Double, String> known = new HashMap<>();

  /** Returns a finite number as a literal. */
  public String of(double value) {
    return known.computeIfAbsent(value, this::literal);
  }

  private String literal(double value) {
    int length = shortest.write(value, buffer, 0);
    String text = new String(buffer, 0, length, StandardCharsets.US_ASCII);
    boolean whole = text.indexOf('.') < 0 && text.indexOf('e') < 0;
    return whole ? text + ".0" : text;
  }
}
