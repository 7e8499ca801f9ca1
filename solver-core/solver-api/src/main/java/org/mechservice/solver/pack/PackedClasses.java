package org.mechservice.solver.pack;

import java.io.IOException;
import java.util.SortedMap;
import java.util.TreeMap;

/** Packs class files together, and unpacks them. */
public final class PackedClasses {
  /** Name of the entry of a JAR that holds packed classes. */
  public static final String ENTRY = "META-INF/mech.classes";

  /** Attribute of a JAR's manifest: hash of the classes in the form of {@link KeptClasses}. */
  public static final String KEPT_SHA_256 = "Mech-Classes-SHA-256";

  private static final String SUFFIX = ".class";
  private static final int MAJOR_VERSION = 6;

  private PackedClasses() {}

  /**
   * Packs class files. The same classes give the same bytes.
   *
   * @param classFiles class files by path, such as {@code org/mechservice/solver/api/Model.class};
   *     not modified
   * @throws IllegalArgumentException if one of them has an attribute that running it does not need,
   *     or that is not known here
   */
  public static byte[] pack(SortedMap<String, byte[]> classFiles) {
    SymbolWriter symbols = new SymbolWriter();
    try {
      Constants constants = new Constants(symbols);
      symbols.pair(BandNumbers.CLASS_COUNT, classFiles.size());
      for (byte[] classFile : classFiles.values()) {
        symbols.symbol(BandNumbers.VERSION, classFile[MAJOR_VERSION + 1]);
        new ClassWalk(new Packing(classFile, symbols, constants), symbols.surroundings()).walk();
      }
    } catch (IOException e) {
      throw new IllegalStateException("symbols in memory can always be written", e);
    }
    return symbols.bytes();
  }

  /**
   * Unpacks class files.
   *
   * @param packed what {@link #pack} returned; not modified
   * @return class files by path
   * @throws IOException if it is damaged
   */
  public static SortedMap<String, byte[]> unpack(byte[] packed) throws IOException {
    SymbolReader symbols = new SymbolReader(packed);
    Constants constants = new Constants(symbols);
    int count = symbols.pair(BandNumbers.CLASS_COUNT, 0);
    SortedMap<String, byte[]> classFiles = new TreeMap<>();
    for (int i = 0; i < count; i++) {
      int version = symbols.symbol(BandNumbers.VERSION, 0);
      Unpacking unpacking = new Unpacking(symbols, constants);
      try {
        new ClassWalk(unpacking, symbols.surroundings()).walk();
      } catch (IllegalArgumentException e) {
        throw new IOException("the packed classes are damaged", e);
      }
      classFiles.put(unpacking.name() + SUFFIX, unpacking.file(version));
    }
    return classFiles;
  }
}
