package org.mechservice.solver.compact;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.RecordComponent;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.expression.Expression;

/**
 * Writes immutable descriptions: records of numbers, texts, enumerated values, lists and records.
 *
 * <p>Every value begins with its kind. A text, and the name of a record or of an enumeration, is
 * written at its first occurrence and numbered; later occurrences are the number. So is an object
 * of a formula that stands in several places: formulas that share parts keep their size.
 */
final class RecordWriter {
  /** Kinds of values; zero and one, the commonest numbers, are kinds of their own. */
  static final int ZERO = 0;

  static final int ONE = 1;
  static final int DOUBLE = 2;
  static final int INTEGER = 3;
  static final int FALSE = 4;
  static final int TRUE = 5;
  static final int TEXT = 6;
  static final int ENUM = 7;
  static final int LIST = 8;
  static final int RECORD = 9;
  static final int AGAIN = 10;

  /** Common package prefix of records and enumerations; their names are written without it. */
  static final String HOME = "org.mechservice.solver.";

  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
  private final DataOutputStream out = new DataOutputStream(bytes);
  private final Map<String, Integer> numbers = new HashMap<>();
  private final IdentityHashMap<Expression, Integer> expressions = new IdentityHashMap<>();

  /**
   * Appends a value.
   *
   * @throws IllegalArgumentException if it is of another kind
   */
  RecordWriter write(Object value) {
    try {
      put(value);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return this;
  }

  /** Returns what was written. */
  byte[] bytes() {
    return bytes.toByteArray();
  }

  private void put(Object value) throws IOException {
    if (value instanceof Double number) {
      putDouble(number);
    } else if (value instanceof Integer number) {
      out.write(INTEGER);
      putCount(number >= 0 ? 2 * number : -2 * number - 1);
    } else if (value instanceof Boolean truth) {
      out.write(truth ? TRUE : FALSE);
    } else if (value instanceof String text) {
      out.write(TEXT);
      putText(text);
    } else if (value instanceof Enum<?> constant) {
      out.write(ENUM);
      putName(constant.getDeclaringClass());
      putText(constant.name());
    } else if (value instanceof List<?> list) {
      out.write(LIST);
      putCount(list.size());
      for (Object element : list) {
        put(element);
      }
    } else if (value instanceof Expression expression) {
      putExpression(expression);
    } else if (value instanceof Record record) {
      putRecord(record);
    } else {
      throw new IllegalArgumentException("a " + value.getClass() + " has no compact form");
    }
  }

  private void putDouble(double number) throws IOException {
    if (Double.doubleToRawLongBits(number) == 0) {
      out.write(ZERO);
    } else if (number == 1) {
      out.write(ONE);
    } else {
      out.write(DOUBLE);
      out.writeDouble(number);
    }
  }

  /** Writes an expression after its parts, which have the lower numbers. */
  private void putExpression(Expression expression) throws IOException {
    Integer number = expressions.get(expression);
    if (number != null) {
      out.write(AGAIN);
      putCount(number);
      return;
    }
    putRecord((Record) expression);
    expressions.put(expression, expressions.size());
  }

  private void putRecord(Record record) throws IOException {
    out.write(RECORD);
    putName(record.getClass());
    for (RecordComponent component : record.getClass().getRecordComponents()) {
      try {
        component.getAccessor().setAccessible(true);
        put(component.getAccessor().invoke(record));
      } catch (ReflectiveOperationException e) {
        throw new IllegalArgumentException("cannot read " + component, e);
      }
    }
  }

  private void putName(Class<?> type) throws IOException {
    if (!type.getName().startsWith(HOME)) {
      throw new IllegalArgumentException(type + " has no compact form");
    }
    putText(type.getName().substring(HOME.length()));
  }

  private void putText(String text) throws IOException {
    Integer number = numbers.putIfAbsent(text, numbers.size() + 1);
    if (number == null) {
      byte[] bytes = text.getBytes(StandardCharsets.UTF_8); // a note may name thousands of parts
      putCount(0);
      putCount(bytes.length);
      out.write(bytes);
    } else {
      putCount(number);
    }
  }

  /** Writes seven bits per byte, the lowest first; the eighth marks that more follow. */
  private void putCount(int count) throws IOException {
    int rest = count;
    for (; (rest & ~0x7f) != 0; rest >>>= 7) {
      out.write((rest & 0x7f) | 0x80);
    }
    out.write(rest);
  }
}
