package org.mechservice.client;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.Arrays;
import org.omg.CORBA.NO_IMPLEMENT;

/** Lets an object answer those operations of an interface that it happens to have. */
final class Script {
  private Script() {}

  /** Returns the interface, its operations answered by the public methods of the same name. */
  static <T> T play(Class<T> operations, Object script) {
    return operations.cast(
        Proxy.newProxyInstance(
            operations.getClassLoader(),
            new Class<?>[] {operations},
            (proxy, operation, arguments) -> answer(script, operation, arguments)));
  }

  private static Object answer(Object script, Method operation, Object[] arguments)
      throws Throwable {
    Method method =
        Arrays.stream(script.getClass().getDeclaredMethods())
            .filter(candidate -> candidate.getName().equals(operation.getName()))
            .findFirst()
            .orElseThrow(() -> new NO_IMPLEMENT("the script has no " + operation.getName()));
    try {
      method.setAccessible(true);
      return method.invoke(script, arguments);
    } catch (InvocationTargetException e) {
      throw e.getCause();
    }
  }
}
