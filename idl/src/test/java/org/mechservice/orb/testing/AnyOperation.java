package org.mechservice.orb.testing;

import java.lang.reflect.Array;
import java.lang.reflect.Method;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.HostInfo;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.orb.GuardedServant;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.NO_PERMISSION;

/** Calls of operations of the contract with arguments that mean nothing, to see who is refused. */
public final class AnyOperation {
  private AnyOperation() {}

  /** Returns arguments of the right types. */
  public static @Nullable Object[] arguments(Method operation) {
    return Stream.of(operation.getParameterTypes()).map(AnyOperation::argument).toArray();
  }

  private static @Nullable Object argument(Class<?> type) {
    if (type == String.class) {
      return "x";
    } else if (type == ModelFile.class) {
      return new ModelFile("x", new byte[0]);
    } else if (type == HostInfo.class) {
      return new HostInfo("x", "0", "127.0.0.1:1", 1, 1, 1, 0);
    } else if (type.isArray()) {
      return Array.newInstance(type.getComponentType(), 0);
    } else if (type.isPrimitive()) {
      return Array.get(Array.newInstance(type, 1), 0);
    } else if (org.omg.CORBA.Object.class.isAssignableFrom(type)) {
      return null; // no client is called back
    }
    try {
      return type.getConstructor().newInstance(); // a holder
    } catch (ReflectiveOperationException e) {
      throw new LinkageError(type.getName(), e);
    }
  }

  /** Returns whether a call was refused because of its caller. */
  public static boolean isRefusal(@Nullable Throwable thrown) {
    return thrown instanceof NotAuthorized
        || (thrown instanceof NO_PERMISSION no
            && (GuardedServant.isRefusal(no, MessageCode.NOT_THE_OWNER)
                || GuardedServant.isRefusal(no, MessageCode.CERTIFICATE_NOT_ALLOWED)));
  }
}
