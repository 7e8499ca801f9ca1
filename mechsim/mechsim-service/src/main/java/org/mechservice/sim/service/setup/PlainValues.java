package org.mechservice.sim.service.setup;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.StreamCorruptedException;
import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.omg.CORBA.UserException;
import org.omg.CORBA.portable.IDLEntity;

/**
 * Writes and reads plain values by their declared type: numbers, texts, bytes, enums, arrays,
 * lists, sets, maps, optional values, records, and structs, enums and exceptions of the contract.
 * What is read has the type that the reader asks for, whatever the bytes are: no name of a class
 * travels.
 */
final class PlainValues {
  /** Largest array of a value, elements or B. */
  private static final int LARGEST = 1 << 30;

  private PlainValues() {}

  /**
   * Writes a value.
   *
   * @param type its declared type
   * @throws IllegalArgumentException if it is none of the types above
   */
  static void write(Type type, Object value, DataOutputStream out) throws IOException {
    if (type instanceof ParameterizedType generic) {
      writeGeneric(generic, value, out);
      return;
    }
    Class<?> plain = (Class<?>) type;
    if (value instanceof Boolean flag) {
      out.writeBoolean(flag);
    } else if (value instanceof Integer number) {
      out.writeInt(number);
    } else if (value instanceof Long number) {
      out.writeLong(number);
    } else if (value instanceof Double number) {
      out.writeDouble(number);
    } else if (value instanceof String text) {
      write(byte[].class, text.getBytes(StandardCharsets.UTF_8), out);
    } else if (value instanceof byte[] bytes) {
      out.writeInt(bytes.length);
      out.write(bytes);
    } else if (value instanceof OptionalDouble number) {
      out.writeBoolean(number.isPresent());
      out.writeDouble(number.orElse(0));
    } else if (value instanceof Enum<?> constant) {
      write(String.class, constant.name(), out);
    } else if (plain.isArray()) {
      int length = Array.getLength(value);
      out.writeInt(length);
      for (int i = 0; i < length; i++) {
        write(plain.getComponentType(), Array.get(value, i), out);
      }
    } else {
      writeParts(plain, value, out);
    }
  }

  private static void writeParts(Class<?> type, Object value, DataOutputStream out)
      throws IOException {
    try {
      if (type.isRecord()) {
        for (RecordComponent part : type.getRecordComponents()) {
          write(part.getGenericType(), part.getAccessor().invoke(value), out);
        }
      } else if (isEnumOfContract(type)) {
        out.writeInt((int) type.getMethod("value").invoke(value));
      } else {
        for (Field part : parts(type)) {
          write(part.getType(), part.get(value), out);
        }
      }
    } catch (ReflectiveOperationException e) {
      throw new IllegalArgumentException(type + " is no plain value", e);
    }
  }

  private static void writeGeneric(ParameterizedType type, Object value, DataOutputStream out)
      throws IOException {
    Type[] of = type.getActualTypeArguments();
    if (value instanceof Optional<?> maybe) {
      out.writeBoolean(maybe.isPresent());
      if (maybe.isPresent()) {
        write(of[0], maybe.get(), out);
      }
    } else if (value instanceof Map<?, ?> map) {
      out.writeInt(map.size());
      for (Map.Entry<?, ?> entry : map.entrySet()) {
        write(of[0], entry.getKey(), out);
        write(of[1], entry.getValue(), out);
      }
    } else {
      Collection<?> all = (Collection<?>) value;
      out.writeInt(all.size());
      for (Object each : all) {
        write(of[0], each, out);
      }
    }
  }

  /**
   * Reads a value.
   *
   * @param type its declared type
   */
  static Object read(Type type, DataInputStream in) throws IOException {
    if (type instanceof ParameterizedType generic) {
      return readGeneric(generic, in);
    }
    Class<?> plain = (Class<?>) type;
    if (plain == boolean.class) {
      return in.readBoolean();
    } else if (plain == int.class) {
      return in.readInt();
    } else if (plain == long.class) {
      return in.readLong();
    } else if (plain == double.class) {
      return in.readDouble();
    } else if (plain == String.class) {
      return new String(bytes(in), StandardCharsets.UTF_8);
    } else if (plain == byte[].class) {
      return bytes(in);
    } else if (plain == OptionalDouble.class) {
      boolean present = in.readBoolean();
      double number = in.readDouble();
      return present ? OptionalDouble.of(number) : OptionalDouble.empty();
    } else if (plain.isEnum()) {
      return constant(plain, String.valueOf(read(String.class, in)));
    } else if (plain.isArray()) {
      Object array = Array.newInstance(plain.getComponentType(), length(in));
      for (int i = 0; i < Array.getLength(array); i++) {
        Array.set(array, i, read(plain.getComponentType(), in));
      }
      return array;
    }
    return readParts(plain, in);
  }

  private static Object constant(Class<?> type, String name) throws IOException {
    for (Object constant : type.getEnumConstants()) {
      if (((Enum<?>) constant).name().equals(name)) {
        return constant;
      }
    }
    throw new StreamCorruptedException(type.getSimpleName() + " has no constant " + name);
  }

  private static Object readParts(Class<?> type, DataInputStream in) throws IOException {
    try {
      if (type.isRecord()) {
        RecordComponent[] parts = type.getRecordComponents();
        Object[] values = new Object[parts.length];
        for (int i = 0; i < parts.length; i++) {
          values[i] = read(parts[i].getGenericType(), in);
        }
        Class<?>[] types =
            Arrays.stream(parts).map(RecordComponent::getType).toArray(Class<?>[]::new);
        return type.getDeclaredConstructor(types).newInstance(values);
      } else if (isEnumOfContract(type)) {
        return type.getMethod("from_int", int.class).invoke(null, in.readInt());
      }
      Object value = type.getConstructor().newInstance();
      for (Field part : parts(type)) {
        part.set(value, read(part.getType(), in));
      }
      return value;
    } catch (ReflectiveOperationException e) {
      throw new IllegalArgumentException(type + " is no plain value", e);
    }
  }

  private static Object readGeneric(ParameterizedType type, DataInputStream in) throws IOException {
    Type[] of = type.getActualTypeArguments();
    Class<?> raw = (Class<?>) type.getRawType();
    if (raw == Optional.class) {
      return in.readBoolean() ? Optional.of(read(of[0], in)) : Optional.empty();
    }
    int length = length(in);
    if (Map.class.isAssignableFrom(raw)) {
      Map<Object, Object> map = raw == SortedMap.class ? new TreeMap<>() : new LinkedHashMap<>();
      for (int i = 0; i < length; i++) {
        map.put(read(of[0], in), read(of[1], in));
      }
      return map;
    }
    Collection<Object> all = raw == Set.class ? new LinkedHashSet<>() : new ArrayList<>();
    for (int i = 0; i < length; i++) {
      all.add(read(of[0], in));
    }
    return all;
  }

  private static byte[] bytes(DataInputStream in) throws IOException {
    int length = length(in);
    byte[] bytes = in.readNBytes(length);
    if (bytes.length < length) {
      throw new StreamCorruptedException("the value ends after " + bytes.length + " bytes");
    }
    return bytes;
  }

  private static int length(DataInputStream in) throws IOException {
    int length = in.readInt();
    if (length < 0 || length > LARGEST) {
      throw new StreamCorruptedException("a value has the length " + length);
    }
    return length;
  }

  private static boolean isEnumOfContract(Class<?> type) {
    return IDLEntity.class.isAssignableFrom(type)
        && Arrays.stream(type.getMethods()).anyMatch(method -> method.getName().equals("from_int"));
  }

  /** Returns the members of a struct or exception of the contract. */
  private static List<Field> parts(Class<?> type) {
    if (!IDLEntity.class.isAssignableFrom(type) && !UserException.class.isAssignableFrom(type)) {
      throw new IllegalArgumentException(type + " is no plain value");
    }
    return Arrays.stream(type.getFields())
        .filter(field -> !Modifier.isStatic(field.getModifiers()))
        .toList();
  }
}
