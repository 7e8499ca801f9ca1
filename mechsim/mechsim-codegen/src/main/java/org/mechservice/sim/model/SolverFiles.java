package org.mechservice.sim.model;

import java.util.Collections;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.mechservice.sim.compile.SolverClasses;
import org.mechservice.sim.jar.LeanClass;

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

  /** Returns one of the files, or null if there is no such file. */
  static byte @Nullable [] lean(String path) {
    byte[] file = SolverClasses.file(path);
    return file == null ? null : lean(path, file);
  }

  private static SortedMap<String, byte[]> makeLean() {
    SortedMap<String, byte[]> lean = new TreeMap<>();
    SolverClasses.files().forEach((path, file) -> lean.put(path, lean(path, file)));
    return Collections.unmodifiableSortedMap(lean);
  }

  private static byte[] lean(String path, byte[] file) {
    return path.endsWith(".class") ? LeanClass.of(file) : file;
  }
}
