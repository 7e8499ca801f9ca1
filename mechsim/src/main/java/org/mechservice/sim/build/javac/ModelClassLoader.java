package org.mechservice.sim.build.javac;

import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.solver.api.Model;

/** Loads the classes of one model; everything else comes from the solver's loader. */
public final class ModelClassLoader extends ClassLoader {
  private final SortedMap<String, byte[]> classFiles;

  /**
   * @param classFiles class files by binary name; not modified
   */
  public ModelClassLoader(SortedMap<String, byte[]> classFiles) {
    super(Model.class.getClassLoader());
    this.classFiles = new TreeMap<>(classFiles);
  }

  @Override
  protected Class<?> findClass(String name) throws ClassNotFoundException {
    byte[] bytes = classFiles.get(name);
    if (bytes == null) {
      throw new ClassNotFoundException(name);
    }
    return defineClass(name, bytes, 0, bytes.length);
  }
}
