package org.mechservice.orb.connection;

import java.lang.reflect.Field;
import org.omg.CORBA.INITIALIZE;

/**
 * A private field of the ORB that has no setting and must be read or set. Should another version of
 * the ORB have no such field, no ORB starts.
 */
public final class OrbField<T> {
  private final Field field;
  private final Class<T> type;

  /**
   * @throws INITIALIZE if the class has no such field
   */
  public OrbField(Class<?> owner, String name, Class<T> type) {
    this.type = type;
    try {
      field = owner.getDeclaredField(name);
      field.setAccessible(true);
    } catch (NoSuchFieldException e) {
      throw unknownVersion(e);
    }
  }

  private static INITIALIZE unknownVersion(Exception cause) {
    return (INITIALIZE) new INITIALIZE("this version of the ORB is not known").initCause(cause);
  }

  /** Returns what an object has there. */
  public T get(Object owner) {
    try {
      return type.cast(field.get(owner));
    } catch (IllegalAccessException e) {
      throw unknownVersion(e);
    }
  }

  /** Puts something else there. */
  void set(Object owner, T value) {
    try {
      field.set(owner, value);
    } catch (IllegalAccessException e) {
      throw unknownVersion(e);
    }
  }
}
