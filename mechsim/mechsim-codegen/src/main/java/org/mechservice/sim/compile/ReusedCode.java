package org.mechservice.sim.compile;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.guard.ModelClassLoader;
import org.mechservice.solver.api.ModelSource;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * Classes of models that differ only in their numbers and texts, loaded once for all of them: where
 * a class file loads a constant, the loaded class reads an element of a static array, which has the
 * constants of the model at hand. The arithmetic and its order are those of the class file, so the
 * bits are, too; and what the virtual machine has compiled serves the next model.
 *
 * <p>Constants of a static initialiser stay where they are: models that differ in these are
 * different classes.
 *
 * <p>Of one thread: the models of a source may be used until the next source is taken.
 */
public final class ReusedCode {
  private static final String NUMBERS = "constantNumbers";
  private static final String TEXTS = "constantTexts";
  private static final int MOST_SHAPES = 16;

  /** Loaded classes by their files without constants, a character a byte; those used latest. */
  private final Map<Map<String, String>, ClassLoader> shapes =
      new LinkedHashMap<>(MOST_SHAPES, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Map<String, String>, ClassLoader> eldest) {
          return size() > MOST_SHAPES;
        }
      };

  /**
   * Returns a source of models of some class files, which have no static fields that change.
   *
   * @param className class to be instantiated
   * @param classFiles class files by binary name; not modified
   */
  public ModelSource source(String className, SortedMap<String, byte[]> classFiles) {
    Map<String, Constants> constants = new TreeMap<>();
    Map<String, String> shape = new TreeMap<>();
    classFiles.forEach(
        (name, bytes) -> {
          Constants taken = new Constants(name.replace('.', '/'));
          constants.put(name, taken);
          shape.put(name, new String(taken.takeFrom(bytes), StandardCharsets.ISO_8859_1));
        });
    ClassLoader loader = shapes.computeIfAbsent(shape, ReusedCode::load);
    try {
      for (Map.Entry<String, Constants> each : constants.entrySet()) {
        each.getValue().putIn(Class.forName(each.getKey(), false, loader));
      }
      return ModelSource.from(loader.loadClass(className).getConstructor().newInstance());
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(
          "the generated class " + className + " cannot be instantiated", e);
    }
  }

  private static ClassLoader load(Map<String, String> shape) {
    SortedMap<String, byte[]> files = new TreeMap<>();
    shape.forEach((name, text) -> files.put(name, text.getBytes(StandardCharsets.ISO_8859_1)));
    return new ModelClassLoader(files, ModelSource.class.getClassLoader());
  }

  /** Takes the constants out of a class file. */
  private static final class Constants {
    private final String owner;
    private final List<Double> numbers = new ArrayList<>();
    private final List<String> texts = new ArrayList<>();

    Constants(String owner) {
      this.owner = owner;
    }

    /** Returns the class file that reads its constants from two static arrays. */
    byte[] takeFrom(byte[] classFile) {
      ClassWriter out = new ClassWriter(ClassWriter.COMPUTE_MAXS);
      new ClassReader(classFile)
          .accept(
              new ClassVisitor(Opcodes.ASM9, out) {
                @Override
                public MethodVisitor visitMethod(
                    int access, String name, String descriptor, String generic, String[] thrown) {
                  MethodVisitor code = super.visitMethod(access, name, descriptor, generic, thrown);
                  return name.equals("<clinit>") ? code : reading(code);
                }
              },
              0);
      field(out, NUMBERS, "[D");
      field(out, TEXTS, "[Ljava/lang/String;");
      return out.toByteArray();
    }

    private static void field(ClassWriter out, String name, String type) {
      int access = Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC | Opcodes.ACC_SYNTHETIC;
      out.visitField(access, name, type, null, null).visitEnd();
    }

    private MethodVisitor reading(MethodVisitor code) {
      return new MethodVisitor(Opcodes.ASM9, code) {
        @Override
        public void visitLdcInsn(Object value) {
          if (value instanceof Double number) {
            element(NUMBERS, "[D", numbers.size(), Opcodes.DALOAD);
            numbers.add(number);
          } else if (value instanceof String text) {
            element(TEXTS, "[Ljava/lang/String;", texts.size(), Opcodes.AALOAD);
            texts.add(text);
          } else {
            super.visitLdcInsn(value);
          }
        }

        private void element(String array, String type, int index, int load) {
          super.visitFieldInsn(Opcodes.GETSTATIC, owner, array, type);
          if (index <= Short.MAX_VALUE) {
            super.visitIntInsn(Opcodes.SIPUSH, index);
          } else {
            super.visitLdcInsn(index);
          }
          super.visitInsn(load);
        }
      };
    }

    void putIn(Class<?> loaded) throws ReflectiveOperationException {
      double[] values = new double[numbers.size()];
      for (int i = 0; i < values.length; i++) {
        values[i] = numbers.get(i);
      }
      loaded.getField(NUMBERS).set(null, values);
      loaded.getField(TEXTS).set(null, texts.toArray(String[]::new));
    }
  }
}
