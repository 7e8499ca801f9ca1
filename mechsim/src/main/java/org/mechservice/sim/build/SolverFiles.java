package org.mechservice.sim.build;

import java.util.Collections;
import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.sim.build.jar.LeanClass;
import org.mechservice.sim.build.javac.SolverClasses;

/** The solver's files as JARs carry them. */
final class SolverFiles {
  private SolverFiles() {}

  /** Made once per process, when first needed. */
  private static final class Holder {
    private static final SortedMap<String, byte[]> LEAN = makeLean();
  }

  /** Returns the files by path, class files without what running them does not need. */
  static SortedMap<String, byte[]> lean() {
    return Holder.LEAN;
  }

  private static SortedMap<String, byte[]> makeLean() {
    SortedMap<String, byte[]> lean = new TreeMap<>();
    SolverClasses.files()
        .forEach(
            (path, bytes) -> lean.put(path, path.endsWith(".class") ? LeanClass.of(bytes) : bytes));
    return Collections.unmodifiableSortedMap(lean);
  }
}
