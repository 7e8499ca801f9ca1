package org.mechservice.sim.compile;

import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.solver.api.Model;

/**
 * Loads the classes of one model; those that users have written from a loader of their own,
 * everything else from the solver's.
 */
public final class ModelClassLoader extends ClassLoader {
  private final SortedMap<String, byte[]> classFiles;
  private final ClassLoader userClasses;

  /**
   * @param classFiles class files by binary name; not modified
   * @param userClasses loads what the model's users have written
   */
  public ModelClassLoader(SortedMap<String, byte[]> classFiles, ClassLoader userClasses) {
    super(Model.class.getClassLoader());
    this.classFiles = new TreeMap<>(classFiles);
    this.userClasses = userClasses;
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
