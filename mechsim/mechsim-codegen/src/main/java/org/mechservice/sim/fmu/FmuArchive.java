package org.mechservice.sim.fmu;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.time.LocalDateTime;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.UUID;
import java.util.stream.Collectors;
import java.util.zip.Deflater;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.mechservice.solver.text.Sha256;

/** The file of an FMU, and the notes about it. */
public final class FmuArchive {
  /** Date of all entries; see {@link org.mechservice.sim.packaging.ReproducibleJar}. */
  private static final LocalDateTime DATE = LocalDateTime.of(1980, 2, 1, 0, 0);

  private final byte[] bytes;
  private final String contents;

  private FmuArchive(byte[] bytes, String contents) {
    this.bytes = bytes;
    this.contents = contents;
  }

  /**
   * Builds an FMU with a binary for this machine, or with its sources alone where no compiler is.
   *
   * @throws IOException if the compiler fails; the message has its words
   */
  public static FmuArchive build(FmuModel model, FmiVersion version) throws IOException {
    Optional<FmuPlatform> here =
        FmuPlatform.ofThisMachine().filter(platform -> CCompiler.forPlatform(platform).isPresent());
    if (here.isPresent()) {
      return build(model, version, EnumSet.of(here.get()));
    }
    FmuArchive source = build(model, version, Set.of());
    return new FmuArchive(
        source.bytes,
        "sources only: this machine has no C compiler (cc, gcc, clang or zig); the importer"
            + " compiles them");
  }

  /**
   * Builds an FMU with binaries for platforms.
   *
   * @param platforms platforms; none for an FMU of sources
   * @throws IllegalArgumentException if this machine has no compiler for one of them
   * @throws IOException if a compiler fails; the message has its words
   */
  public static FmuArchive build(FmuModel model, FmiVersion version, Set<FmuPlatform> platforms)
      throws IOException {
    Map<FmuPlatform, CCompiler> compilers = new TreeMap<>();
    for (FmuPlatform platform : platforms) {
      compilers.put(
          platform, CCompiler.forPlatform(platform).orElseThrow(() -> noCompiler(platform)));
    }
    String token = token(model, version);
    SortedMap<String, String> sources = FmuSources.of(model, version, token);
    List<String> compiled = FmuSources.compiled(sources);
    SortedMap<String, byte[]> entries = new TreeMap<>();
    sources.forEach((name, text) -> entries.put("sources/" + name, utf8(text)));
    if (version == FmiVersion.FMI_3) {
      entries.put("sources/buildDescription.xml", utf8(FmuDescription.build(model, compiled)));
    }
    for (Map.Entry<FmuPlatform, CCompiler> compiler : compilers.entrySet()) {
      String path = compiler.getKey().path(version, model.identifier());
      entries.put(path, compiler.getValue().compile(sources));
    }
    String description = FmuDescription.of(model, version, token, compiled);
    String contents =
        platforms.isEmpty()
            ? "sources only: the importer compiles them"
            : "sources and binaries for "
                + compilers.keySet().stream()
                    .map(FmuPlatform::label)
                    .collect(Collectors.joining(", "));
    return new FmuArchive(zip(utf8(description), entries), contents);
  }

  private static IllegalArgumentException noCompiler(FmuPlatform platform) {
    boolean here = FmuPlatform.ofThisMachine().equals(Optional.of(platform));
    return new IllegalArgumentException(
        "no C compiler for "
            + platform.label()
            + (here ? ": install cc, gcc, clang or zig" : ": install zig (pip install ziglang)")
            + ", or write --platforms "
            + FmuPlatform.SOURCE);
  }

  /** Returns the bytes of the file. */
  public byte[] bytes() {
    return bytes.clone();
  }

  /** Returns what it contains, in words. */
  public String contents() {
    return contents;
  }

  /** Returns a UUID of the model's content, in the form both versions take. */
  private static String token(FmuModel model, FmiVersion version) {
    MessageDigest digest = Sha256.digest();
    FmuSources.withoutHeader(model, version)
        .forEach(
            (name, text) -> {
              digest.update(utf8(name));
              digest.update(utf8(text));
            });
    digest.update(utf8(FmuDescription.of(model, version, "", List.of())));
    digest.update(utf8(model.experiment().toString()));
    ByteBuffer hash = ByteBuffer.wrap(digest.digest());
    return "{" + new UUID(hash.getLong(), hash.getLong()) + "}";
  }

  private static byte[] utf8(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private static byte[] zip(byte[] description, SortedMap<String, byte[]> entries) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream out = new ZipOutputStream(bytes)) {
      out.setLevel(Deflater.BEST_COMPRESSION);
      write("modelDescription.xml", description, out);
      for (Map.Entry<String, byte[]> entry : entries.entrySet()) {
        write(entry.getKey(), entry.getValue(), out);
      }
    } catch (IOException e) {
      throw new UncheckedIOException("bytes in memory can always be written", e);
    }
    return bytes.toByteArray();
  }

  private static void write(String path, byte[] content, ZipOutputStream out) throws IOException {
    ZipEntry entry = new ZipEntry(path);
    entry.setTimeLocal(DATE);
    out.putNextEntry(entry);
    out.write(content);
    out.closeEntry();
  }
}
