package org.mechservice.guard;

import java.util.SortedMap;
import org.mechservice.solver.api.UserForce;

/**
 * Loads user classes. They can refer to each other, to the packages {@code java.*} and to the force
 * interface, and to nothing else in this process. A given class takes precedence over all others,
 * and a name that is neither given nor in those packages is not found, even if the platform has
 * such a class.
 */
public final class UserClassLoader extends ClassLoader {
  private static final String INTERFACE = UserForce.class.getPackageName();

  private final SortedMap<String, byte[]> classFiles;

  /**
   * @param classFiles by binary name; not modified
   */
  public UserClassLoader(SortedMap<String, byte[]> classFiles) {
    super("user-forces", ClassLoader.getPlatformClassLoader());
    this.classFiles = classFiles;
  }

  @Override
  protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
    if (name.startsWith("java.")) {
      return super.loadClass(name, resolve);
    }
    synchronized (getClassLoadingLock(name)) {
      Class<?> loaded = findLoadedClass(name);
      Class<?> found = loaded == null ? findClass(name) : loaded;
      if (resolve) {
        resolveClass(found);
      }
      return found;
    }
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
