package org.mechservice.guard;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.ref.Cleaner;
import java.lang.ref.WeakReference;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicLong;
import org.mechservice.solver.api.UserForce;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * Forces of users for a program that runs models in its own process. Their classes are loaded in
 * confined processes; here there are classes of the same names that hand each call on.
 *
 * <p>Each thread that makes forces has a process of its own, as far as there are processors; the
 * processes end with this object and with the program. A class with a static field has one for each
 * loader and process. May be used by several threads.
 */
public final class ForceRelay {
  /** What a process may use: 1 GiB of heap, and the processor time of the run. */
  private static final WorkerBounds BOUNDS = new WorkerBounds(1L << 30, -1);

  private static final Cleaner CLEANER = Cleaner.create();
  private static final AtomicLong LOADERS = new AtomicLong();

  private final SortedMap<String, byte[]> classFiles;
  private final UserCode consent;
  private final Processes processes = new Processes();

  /**
   * @param classFiles class files by binary name, verified by {@link BytecodeVerifier}; not
   *     modified
   * @param consent whether they may run where they cannot be confined
   */
  @SuppressWarnings("this-escape") // The processes end when nobody has this object any more.
  public ForceRelay(SortedMap<String, byte[]> classFiles, UserCode consent) {
    this.classFiles = Collections.unmodifiableSortedMap(new TreeMap<>(classFiles));
    this.consent = consent;
    CLEANER.register(this, processes::end);
  }

  /**
   * Returns a loader of the classes that hand calls on. It finds the classes of users alone.
   *
   * @throws IllegalArgumentException S-168 if this machine cannot confine them and there is no
   *     consent to that
   */
  public ClassLoader newLoader() {
    consent
        .refusal(Confinement.ofThisMachine())
        .ifPresent(
            why -> {
              throw new IllegalArgumentException(why);
            });
    return new RelayLoader(this);
  }

  /** The processes of a relay. */
  private static final class Processes {
    private record Place(WeakReference<Thread> user, RelayProcess process) {}

    private final Deque<Place> places = new ArrayDeque<>();
    private boolean ended;

    /** Returns the process of this thread, or one whose thread has ended, or a new one. */
    synchronized RelayProcess ofThisThread() throws IOException {
      places.removeIf(place -> !place.process().isAlive());
      Thread self = Thread.currentThread();
      for (Place place : places) {
        if (place.user().get() == self) {
          return place.process();
        }
      }
      for (Place place : places) {
        Thread user = place.user().get();
        if (user == null || !user.isAlive()) {
          places.remove(place);
          return add(self, place.process());
        }
      }
      if (places.size() < Math.max(2, Runtime.getRuntime().availableProcessors())) {
        return add(self, new RelayProcess(BOUNDS));
      }
      Place shared = places.removeFirst();
      places.addLast(shared);
      return shared.process();
    }

    private RelayProcess add(Thread user, RelayProcess process) {
      if (ended) {
        process.end();
      }
      places.add(new Place(new WeakReference<>(user), process));
      return process;
    }

    synchronized void end() {
      ended = true;
      places.forEach(place -> place.process().end());
    }
  }

  /** Loads classes that hand calls on. */
  static final class RelayLoader extends ClassLoader {
    private static final String CONSTRUCTOR = "<init>";

    private final ForceRelay relay;
    private final long id = LOADERS.incrementAndGet();

    RelayLoader(ForceRelay relay) {
      super("relayed-forces", RelayedForce.class.getClassLoader());
      this.relay = relay;
    }

    /**
     * Makes a force in a process.
     *
     * @throws IllegalStateException if it cannot be made; says why
     */
    RelayProcess.Handle create(RelayedForce owner) {
      try {
        RelayProcess process = relay.processes.ofThisThread();
        RelayProcess.Handle handle =
            process.create(id, relay.classFiles, owner.getClass().getName());
        CLEANER.register(owner, handle::release);
        return handle;
      } catch (IOException e) {
        throw new UncheckedIOException("no process can be started for it", e);
      }
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
      if (!relay.classFiles.containsKey(name)) {
        return super.loadClass(name, resolve);
      }
      synchronized (getClassLoadingLock(name)) {
        Class<?> loaded = findLoadedClass(name);
        return loaded == null ? findClass(name) : loaded;
      }
    }

    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
      if (!relay.classFiles.containsKey(name)) {
        throw new ClassNotFoundException(name);
      }
      byte[] file = classFile(name);
      return defineClass(name, file, 0, file.length);
    }

    private byte[] classFile(String name) {
      Class<?> parent =
          relay.differentiates(name) ? RelayedForce.WithDerivatives.class : RelayedForce.class;
      ClassWriter file = new ClassWriter(ClassWriter.COMPUTE_MAXS);
      int access = Opcodes.ACC_PUBLIC | Opcodes.ACC_FINAL | Opcodes.ACC_SUPER;
      String internal = Type.getInternalName(parent);
      file.visit(Opcodes.V17, access, name.replace('.', '/'), null, internal, null);
      MethodVisitor code = file.visitMethod(Opcodes.ACC_PUBLIC, CONSTRUCTOR, "()V", null, null);
      code.visitCode();
      code.visitVarInsn(Opcodes.ALOAD, 0);
      code.visitMethodInsn(Opcodes.INVOKESPECIAL, internal, CONSTRUCTOR, "()V", false);
      code.visitInsn(Opcodes.RETURN);
      code.visitMaxs(0, 0);
      code.visitEnd();
      file.visitEnd();
      return file.toByteArray();
    }
  }

  /** Returns whether a class or one of its superclasses has derivatives of its own. */
  private boolean differentiates(String name) {
    Set<String> seen = new HashSet<>();
    Deque<String> open = new ArrayDeque<>(List.of(name));
    while (!open.isEmpty()) {
      byte[] file = classFiles.get(open.remove());
      if (file == null) {
        continue;
      }
      ClassReader reader = new ClassReader(file);
      List<String> parents = new ArrayList<>(List.of(reader.getInterfaces()));
      if (reader.getSuperName() != null) {
        parents.add(reader.getSuperName());
      }
      for (String parent : parents) {
        if (parent.equals(Type.getInternalName(UserForce.Derivatives.class))) {
          return true;
        } else if (seen.add(parent)) {
          open.add(parent.replace('/', '.'));
        }
      }
    }
    return false;
  }
}
