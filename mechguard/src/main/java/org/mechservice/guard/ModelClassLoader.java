package org.mechservice.guard;

import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.solver.api.Model;

/**
 * Loads the classes of one model; user classes come from their own loader, all other classes from
 * the solver's, which is not asked for the model's: it would seek them in every JAR.
 */
public final class ModelClassLoader extends ClassLoader {
  private final SortedMap<String, byte[]> classFiles;
  private final ClassLoader userClasses;

  /**
   * @param classFiles class files by binary name; not modified
   * @param userClasses loader of the user classes
   */
  public ModelClassLoader(SortedMap<String, byte[]> classFiles, ClassLoader userClasses) {
    super(Model.class.getClassLoader());
    this.classFiles = new TreeMap<>(classFiles);
    this.userClasses = userClasses;
  }

  @Override
  protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
    if (!classFiles.containsKey(name)) {
      return super.loadClass(name, resolve);
    }
    synchronized (getClassLoadingLock(name)) {
      Class<?> loaded = findLoadedClass(name);
      return loaded == null ? findClass(name) : loaded;
    }
  }

  @Override
  protected Class<?> findClass(String name) throws ClassNotFoundException {
    byte[] bytes = classFiles.get(name);
    if (bytes == null) {
      return userClasses.loadClass(name);
    }
    return defineClass(name, bytes, 0, bytes.length);
  }
}
