package org.mechservice.sim.user;

import java.lang.reflect.Modifier;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import org.jspecify.annotations.Nullable;
import org.mechservice.solver.api.UserForce;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/** Checks, without loading it, that a class is a force and has a usable constructor. */
final class ForceClassCheck {
  private static final Set<String> FORCES =
      Set.of(
          Type.getInternalName(UserForce.class), Type.getInternalName(UserForce.Derivatives.class));

  private final SortedMap<String, byte[]> given;
  private final UserCodeFindings findings;

  ForceClassCheck(SortedMap<String, byte[]> given, UserCodeFindings findings) {
    this.given = given;
    this.findings = findings;
  }

  /**
   * Adds a finding if the class cannot be the force.
   *
   * @param who the force, for the message
   */
  void check(UserForceElement force, String who) {
    byte[] bytes = given.getOrDefault(force.className(), new byte[0]);
    String why = why(bytes);
    if (!why.isEmpty()) {
      findings.add(
          MessageCode.FORCE_CLASS_UNUSABLE,
          force.className(),
          who + " is this class, which " + why + "; see UserForce in docs/mechml.md");
    }
  }

  private String why(byte[] bytes) {
    Head head = new Head();
    new ClassReader(bytes)
        .accept(head, ClassReader.SKIP_CODE | ClassReader.SKIP_DEBUG | ClassReader.SKIP_FRAMES);
    int access = head.access;
    if (!isForce(bytes)) {
      return "does not implement " + UserForce.class.getName();
    } else if (Modifier.isAbstract(access) || Modifier.isInterface(access)) {
      return "is abstract";
    } else if (!Modifier.isPublic(access)) {
      return "is not public";
    }
    return head.constructor ? "" : "has no public constructor without parameters";
  }

  /** Returns whether a class or one of its superclasses is a force. */
  private boolean isForce(byte[] bytes) {
    Set<String> seen = new HashSet<>();
    Deque<byte[]> open = new ArrayDeque<>();
    open.add(bytes);
    while (!open.isEmpty()) {
      ClassReader reader = new ClassReader(open.remove());
      List<String> parents = new ArrayList<>(List.of(reader.getInterfaces()));
      parents.add(reader.getSuperName());
      for (String parent : parents) {
        byte[] file = given.get(parent.replace('/', '.'));
        if (FORCES.contains(parent)) {
          return true;
        } else if (file != null && seen.add(parent)) {
          open.add(file);
        }
      }
    }
    return false;
  }

  /** The header of a class, and whether it has the constructor. */
  private static final class Head extends ClassVisitor {
    private int access;
    private boolean constructor;

    Head() {
      super(Opcodes.ASM9);
    }

    @Override
    public void visit(
        int version,
        int access,
        String name,
        @Nullable String signature,
        String superName,
        String[] interfaces) {
      this.access = access;
    }

    @Override
    public @Nullable MethodVisitor visitMethod(
        int access,
        String name,
        String descriptor,
        @Nullable String signature,
        String @Nullable [] exceptions) {
      constructor |= name.equals("<init>") && descriptor.equals("()V") && Modifier.isPublic(access);
      return null;
    }
  }
}
