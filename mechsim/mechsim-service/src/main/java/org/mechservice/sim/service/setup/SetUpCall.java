package org.mechservice.sim.service.setup;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StreamCorruptedException;
import java.io.StringWriter;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Type;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.omg.CORBA.UserException;

/** One operation of {@link SetUps} as it travels to another process and its answer back. */
final class SetUpCall {
  /** The same order in both processes. */
  private static final List<Method> OPERATIONS =
      Arrays.stream(SetUps.class.getMethods())
          .sorted(Comparator.comparing(Method::getName))
          .toList();

  private static final int ANSWERED = 0;
  private static final int REFUSED = 1;
  private static final int THROWN = 2;

  /** Longest text of an unexpected exception, characters. */
  private static final int MOST_TEXT = 10_000;

  private SetUpCall() {}

  /** Returns the operation of a name. */
  static Method operation(String name) {
    return OPERATIONS.stream()
        .filter(operation -> operation.getName().equals(name))
        .findFirst()
        .orElseThrow();
  }

  /**
   * Writes a call and reads its answer.
   *
   * @return what the operation returns, or the {@link UserException} that it throws
   * @throws IllegalStateException if the other process met an unexpected exception
   */
  static Object hold(Method operation, Object[] arguments, DataOutputStream out, DataInputStream in)
      throws IOException {
    out.writeByte(OPERATIONS.indexOf(operation));
    Type[] types = operation.getGenericParameterTypes();
    for (int i = 0; i < types.length; i++) {
      PlainValues.write(types[i], arguments[i], out);
    }
    out.flush();
    return switch (in.readByte()) {
      case ANSWERED -> PlainValues.read(operation.getGenericReturnType(), in);
      case REFUSED -> refusal(operation, in);
      default -> throw new IllegalStateException((String) PlainValues.read(String.class, in));
    };
  }

  private static Object refusal(Method operation, DataInputStream in) throws IOException {
    Class<?>[] refusals = refusals(operation);
    int which = in.readByte();
    if (which < 0 || which >= refusals.length) {
      throw new StreamCorruptedException(operation.getName() + " has no refusal " + which);
    }
    return PlainValues.read(refusals[which], in);
  }

  private static Class<?>[] refusals(Method operation) {
    return Arrays.stream(operation.getExceptionTypes())
        .sorted(Comparator.comparing(Class::getName))
        .toArray(Class<?>[]::new);
  }

  /**
   * Reads a call, carries it out and writes its answer.
   *
   * @param index of the operation, which has been read
   */
  static void answer(SetUps setUps, int index, DataInputStream in, DataOutputStream out)
      throws IOException {
    Method operation = OPERATIONS.get(index);
    Type[] types = operation.getGenericParameterTypes();
    Object[] arguments = new Object[types.length];
    for (int i = 0; i < types.length; i++) {
      arguments[i] = PlainValues.read(types[i], in);
    }
    Object answer;
    try {
      answer = operation.invoke(setUps, arguments);
    } catch (InvocationTargetException e) {
      refuse(operation, e.getCause() == null ? e : e.getCause(), out);
      return;
    } catch (IllegalAccessException e) {
      throw new IllegalStateException(e);
    }
    out.writeByte(ANSWERED);
    PlainValues.write(operation.getGenericReturnType(), answer, out);
  }

  private static void refuse(Method operation, Throwable thrown, DataOutputStream out)
      throws IOException {
    if (thrown instanceof OutOfMemoryError full) {
      throw full; // ends the process with a status of its own
    }
    List<Class<?>> refusals = List.of(refusals(operation));
    int which = refusals.indexOf(thrown.getClass());
    if (which >= 0) {
      out.writeByte(REFUSED);
      out.writeByte(which);
      PlainValues.write(thrown.getClass(), thrown, out);
    } else {
      out.writeByte(THROWN);
      String text = trace(thrown);
      PlainValues.write(String.class, text.substring(0, Math.min(text.length(), MOST_TEXT)), out);
    }
  }

  private static String trace(Throwable thrown) {
    StringWriter text = new StringWriter();
    thrown.printStackTrace(new PrintWriter(text, true));
    return text.toString();
  }
}
