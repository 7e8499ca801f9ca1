package org.mechservice.sim.user;

import java.lang.module.ModuleFinder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.mechservice.solver.catalogue.MessageCode;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;

/** Reads the class files, and compiles the sources, that came with a model. */
final class UserClassFiles {
  /**
   * Packages of Java, of its past modules and of the product, reserved: user classes must not use
   * them.
   */
  private static final List<String> RESERVED =
      List.of(
          "java.",
          "javax.",
          "jdk.",
          "sun.",
          "com.sun.",
          "netscape.",
          "org.ietf.",
          "org.jcp.",
          "org.omg.",
          "org.w3c.",
          "org.xml.",
          "org.mechservice.");

  /** Packages of the modules of this Java. */
  private static final Set<String> PLATFORM =
      ModuleFinder.ofSystem().findAll().stream()
          .flatMap(module -> module.descriptor().packages().stream())
          .collect(Collectors.toUnmodifiableSet());

  /** The Java version is a class file's version minus this number. */
  private static final int JAVA_ZERO = 44;

  private final UserCodeFindings findings;
  private final SortedMap<String, byte[]> classes = new TreeMap<>();
  private final Map<String, String> fileOf = new HashMap<>();

  private UserClassFiles(UserCodeFindings findings) {
    this.findings = findings;
  }

  /**
   * Returns class files by binary name.
   *
   * @param compile whether sources may be compiled here
   * @param findings receives files that cannot be used; modified
   */
  static SortedMap<String, byte[]> of(
      List<UserFile> files, boolean compile, UserCodeFindings findings) {
    UserClassFiles given = new UserClassFiles(findings);
    List<UserFile> sources = new ArrayList<>();
    for (UserFile file : files) {
      if (!file.isUsable()) {
        findings.add(
            MessageCode.USER_CLASS_FILE_UNUSABLE,
            file.name(),
            "this came with the model, which takes files such as car/Road.java or Road.class");
      } else if (file.isSource()) {
        sources.add(file);
      } else {
        given.read(file);
      }
    }
    if (compile) {
      given.compile(sources);
    } else {
      given.refuse(sources);
    }
    return given.classes;
  }

  private void read(UserFile file) {
    int version = version(file.content());
    if (version < JAVA_ZERO) {
      findings.add(
          MessageCode.USER_CLASS_FILE_UNUSABLE,
          file.name(),
          "this is no class file; compile the class again");
    } else if (version < Opcodes.V1_8) {
      findings.add(
          MessageCode.USER_CLASS_FILE_UNUSABLE,
          file.name(),
          "this was compiled for Java "
              + (version - JAVA_ZERO)
              + ", whose class files are not verified here; compile it with javac --release 17");
    } else if (version > Opcodes.V17) {
      findings.add(
          MessageCode.USER_CLASS_FILE_UNUSABLE,
          file.name(),
          "this was compiled for Java "
              + (version - JAVA_ZERO)
              + ", and models run on Java 17; compile it with javac --release 17");
    } else {
      try {
        ClassReader reader = new ClassReader(file.content());
        reader.accept(new ClassNode(), ClassReader.SKIP_FRAMES);
        add(file.name(), reader.getClassName(), file.content());
      } catch (RuntimeException e) {
        // The reader trusts what it reads: damage shows as any kind of exception.
        findings.add(
            MessageCode.USER_CLASS_FILE_UNUSABLE,
            file.name(),
            "this class file is damaged; compile the class again");
      }
    }
  }

  /** Returns the version of a class file, 0 if it is none. */
  private static int version(byte[] file) {
    boolean magic =
        file.length > 10
            && (file[0] & 0xff) == 0xca
            && (file[1] & 0xff) == 0xfe
            && (file[2] & 0xff) == 0xba
            && (file[3] & 0xff) == 0xbe;
    return magic ? ((file[6] & 0xff) << 8) | (file[7] & 0xff) : 0;
  }

  private void add(String file, String internalName, byte[] content) {
    String name = internalName.replace('/', '.');
    String other = fileOf.putIfAbsent(name, file);
    if (other != null) {
      findings.add(
          MessageCode.USER_CLASS_FILE_UNUSABLE,
          file,
          "this holds the class " + name + ", and so does " + other + "; keep one");
    } else if (isReserved(name)) {
      findings.add(
          MessageCode.USER_CLASS_FILE_UNUSABLE,
          file,
          "the class " + name + " is in a package of Java or MechService; choose another");
    } else {
      classes.put(name, content);
    }
  }

  /** Returns whether Java or the product has, or may have, a class of this name. */
  private static boolean isReserved(String name) {
    int dot = name.lastIndexOf('.');
    return RESERVED.stream().anyMatch(name::startsWith)
        || (dot > 0 && PLATFORM.contains(name.substring(0, dot)));
  }

  private void refuse(List<UserFile> sources) {
    if (!sources.isEmpty()) {
      findings.add(
          MessageCode.USER_CODE_NOT_ALLOWED,
          sources.get(0).name(),
          "this server compiles no classes of users; run without --server, send class files instead"
              + " of sources (javac --release 17) with --mode local, or ask its operator to start"
              + " it with --allow-user-code");
    }
  }

  private void compile(List<UserFile> sources) {
    if (!sources.isEmpty()) {
      Map<String, String> texts = new TreeMap<>();
      sources.forEach(
          source -> texts.put(source.name(), new String(source.content(), StandardCharsets.UTF_8)));
      SourceCompiler.compile(texts, classes, findings)
          .forEach((name, bytes) -> add("the sources", name.replace('.', '/'), bytes));
    }
  }
}
