package org.mechservice.solver.compact;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.RecordComponent;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;

/**
 * Reads what {@link RecordWriter} wrote. It creates only records and enumerations of the solver,
 * through their canonical constructors, for any content of the bytes.
 */
final class RecordReader {
  private final DataInputStream in;
  private final List<String> texts = new ArrayList<>();
  private final List<Expression> expressions = new ArrayList<>();

  /**
   * @param bytes not modified
   */
  RecordReader(byte[] bytes) {
    in = new DataInputStream(new ByteArrayInputStream(bytes));
  }

  /**
   * Returns the next value.
   *
   * @throws IllegalArgumentException S-067 if the bytes end too early or are no compact form
   */
  Object read() {
    try {
      return value();
    } catch (IOException | ReflectiveOperationException | ClassCastException e) {
      throw new IllegalArgumentException(
          MessageCode.MODEL_DATA_DAMAGED
              + " the model's data are damaged or of another version ("
              + e
              + "); build it anew",
          e);
    }
  }

  /** Returns whether values are left. */
  boolean hasMore() {
    try {
      return in.available() > 0;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private Object value() throws IOException, ReflectiveOperationException {
    int kind = in.readUnsignedByte();
    return switch (kind) {
      case RecordWriter.ZERO -> 0.0;
      case RecordWriter.ONE -> 1.0;
      case RecordWriter.DOUBLE -> in.readDouble();
      case RecordWriter.INTEGER -> integer();
      case RecordWriter.FALSE -> false;
      case RecordWriter.TRUE -> true;
      case RecordWriter.TEXT -> text();
      case RecordWriter.ENUM -> constant(type().asSubclass(Enum.class), text());
      case RecordWriter.LIST -> list();
      case RecordWriter.AGAIN -> again();
      case RecordWriter.RECORD -> record(type().asSubclass(Record.class));
      default -> throw new IOException("kind " + kind);
    };
  }

  private int integer() throws IOException {
    int folded = count();
    return (folded & 1) == 0 ? folded >>> 1 : -(folded >>> 1) - 1;
  }

  private List<Object> list() throws IOException, ReflectiveOperationException {
    int size = count();
    List<Object> list = new ArrayList<>();
    for (int i = 0; i < size; i++) {
      list.add(value());
    }
    return List.copyOf(list);
  }

  private Record record(Class<? extends Record> type)
      throws IOException, ReflectiveOperationException {
    RecordComponent[] components = type.getRecordComponents();
    Class<?>[] types = new Class<?>[components.length];
    Object[] values = new Object[components.length];
    for (int i = 0; i < components.length; i++) {
      types[i] = components[i].getType();
      values[i] = value();
    }
    Constructor<? extends Record> constructor = type.getDeclaredConstructor(types);
    constructor.setAccessible(true);
    Record record = constructor.newInstance(values);
    if (record instanceof Expression expression) {
      expressions.add(expression);
    }
    return record;
  }

  private Expression again() throws IOException {
    int number = count();
    if (number >= expressions.size()) {
      throw new IOException("expression " + number);
    }
    return expressions.get(number);
  }

  @SuppressWarnings({"unchecked", "rawtypes"}) // The class is that of an enumeration, just checked.
  private static Object constant(Class<? extends Enum> type, String name) {
    return Enum.valueOf(type, name);
  }

  private Class<?> type() throws IOException, ReflectiveOperationException {
    String name = RecordWriter.HOME + text();
    return Class.forName(name, false, RecordReader.class.getClassLoader());
  }

  private String text() throws IOException {
    int number = count();
    if (number == 0) {
      int length = count();
      if (length < 0 || length > in.available()) {
        throw new IOException("a text of " + length + " bytes");
      }
      texts.add(new String(in.readNBytes(length), StandardCharsets.UTF_8));
      return texts.get(texts.size() - 1);
    }
    if (number > texts.size()) {
      throw new IOException("text " + number);
    }
    return texts.get(number - 1);
  }

  private int count() throws IOException {
    int count = 0;
    for (int shift = 0; shift < 32; shift += 7) {
      int next = in.readUnsignedByte();
      count |= (next & 0x7f) << shift;
      if ((next & 0x80) == 0) {
        return count;
      }
    }
    throw new IOException("a count of more than 32 bits");
  }
}
