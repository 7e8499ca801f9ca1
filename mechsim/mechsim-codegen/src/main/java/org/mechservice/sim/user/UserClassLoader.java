package org.mechservice.sim.user;

import java.util.SortedMap;
import org.mechservice.solver.api.UserForce;

/** Loads classes of users. They see Java and the force interface, not what else runs here. */
final class UserClassLoader extends ClassLoader {
  private static final String INTERFACE = UserForce.class.getPackageName();

  private final SortedMap<String, byte[]> classFiles;

  UserClassLoader(SortedMap<String, byte[]> classFiles) {
    super("user-forces", ClassLoader.getPlatformClassLoader());
    this.classFiles = classFiles;
  }

  @Override
  protected Class<?> findClass(String name) throws ClassNotFoundException {
    byte[] bytes = classFiles.get(name);
    if (bytes != null) {
      return defineClass(name, bytes, 0, bytes.length);
    }
    int dot = name.lastIndexOf('.');
    if (dot < 0 || !name.substring(0, dot).equals(INTERFACE)) {
      throw new ClassNotFoundException(name);
    }
    return Class.forName(name, false, UserForce.class.getClassLoader());
  }
}
