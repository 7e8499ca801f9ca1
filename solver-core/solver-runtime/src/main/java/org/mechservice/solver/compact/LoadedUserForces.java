package org.mechservice.solver.compact;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import org.mechservice.solver.api.UserForce;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.force.UserForceElement;

/** User forces from a class loader, that of the model's JAR. */
public final class LoadedUserForces implements UserForceSource {
  private final ClassLoader loader;

  /**
   * @param loader that of the model's JAR
   */
  public LoadedUserForces(ClassLoader loader) {
    this.loader = loader;
  }

  @Override
  public UserForce create(UserForceElement element) {
    try {
      Class<? extends UserForce> type =
          // Not initialised before it is known what it is.
          Class.forName(element.className(), false, loader).asSubclass(UserForce.class);
      // For a constructor that is called often, reflection would generate a class that needs
      // classes of Java which loaders of user classes do not find.
      return (UserForce)
          MethodHandles.publicLookup()
              .findConstructor(type, MethodType.methodType(void.class))
              .invoke();
    } catch (Throwable e) {
      throw new IllegalArgumentException(
          MessageCode.FORCE_CLASS_UNUSABLE
              + " the class "
              + element.className()
              + " of force \""
              + element.name()
              + "\" cannot be used ("
              + e
              + "); it must be a public class that implements UserForce and has a public"
              + " constructor without parameters",
          e);
    }
  }
}
