package org.mechservice.sim.gradient;

import java.lang.ref.SoftReference;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.TreeMap;
import org.mechservice.guard.ModelClassLoader;
import org.mechservice.sim.emit.GeneratedClass;
import org.mechservice.sim.emit.ModelClass;
import org.mechservice.solver.text.Sha256;

/**
 * Loaded classes of programs by the SHA-256 of their files, those used latest. What the virtual
 * machine has compiled serves the next gradient of the same model, in any thread: the classes hold
 * nothing that changes. They go when memory is short.
 */
final class LoadedCode {
  private static final int MOST = 64;

  private static final Map<String, SoftReference<Class<?>>> LATEST =
      new LinkedHashMap<>(MOST, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, SoftReference<Class<?>>> eldest) {
          return size() > MOST;
        }
      };

  private LoadedCode() {}

  /** Returns the loaded class of a class file. */
  static Class<?> type(GeneratedClass plan) throws ClassNotFoundException {
    byte[] file = plan.classFile();
    String hash = Sha256.of(file);
    synchronized (LATEST) {
      SoftReference<Class<?>> known = LATEST.get(hash);
      Class<?> type = known == null ? null : known.get();
      if (type == null) {
        String name = ModelClass.PACKAGE + "." + plan.simpleName();
        type =
            new ModelClassLoader(
                    new TreeMap<>(Map.of(name, file)), ProgramCode.class.getClassLoader())
                .loadClass(name);
        LATEST.put(hash, new SoftReference<>(type));
      }
      return type;
    }
  }
}
