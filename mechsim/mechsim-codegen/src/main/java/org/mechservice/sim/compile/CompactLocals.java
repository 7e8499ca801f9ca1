package org.mechservice.sim.compile;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.JumpInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.VarInsnNode;

/**
 * Makes the double variables of straight-line methods share slots.
 *
 * <p>The source names every value, and the compiler reserves a slot for each name until the end of
 * its block; beyond slot 255 each access takes twice the bytes. This class frees a variable's slot
 * after its last use. Operations and their order do not change.
 */
final class CompactLocals {
  private CompactLocals() {}

  /** Returns the same class with fewer slots in its methods. */
  static byte[] compacted(byte[] classFile) {
    ClassNode node = new ClassNode();
    new ClassReader(classFile).accept(node, ClassReader.SKIP_FRAMES);
    for (MethodNode method : node.methods) {
      if (!loopsOverDoubles(method)) {
        compact(method);
      }
    }
    ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_FRAMES);
    node.accept(writer);
    return writer.toByteArray();
  }

  /**
   * Returns whether a backward jump crosses a double variable, whose lifetime is then longer than
   * its instructions show.
   */
  private static boolean loopsOverDoubles(MethodNode method) {
    List<Integer> accesses = new ArrayList<>();
    for (int i = 0; i < method.instructions.size(); i++) {
      AbstractInsnNode instruction = method.instructions.get(i);
      if (isDouble(instruction)) {
        accesses.add(i);
      } else if (instruction instanceof JumpInsnNode jump) {
        int target = method.instructions.indexOf(jump.label);
        int end = i;
        if (accesses.stream().anyMatch(access -> access > target && access < end)) {
          return true;
        }
      }
    }
    return false;
  }

  private static boolean isDouble(AbstractInsnNode instruction) {
    return instruction.getOpcode() == Opcodes.DLOAD || instruction.getOpcode() == Opcodes.DSTORE;
  }

  /** Returns the number of slots of the instance and the parameters. */
  private static int parameters(MethodNode method) {
    int slots = Type.getArgumentsAndReturnSizes(method.desc) >> 2;
    return (method.access & Opcodes.ACC_STATIC) == 0 ? slots : slots - 1;
  }

  /** Assigns to each variable the lowest slot that is free during its lifetime. */
  private static void compact(MethodNode method) {
    int parameters = parameters(method);
    Map<Integer, AbstractInsnNode> lastUse = new HashMap<>();
    Set<Integer> others = new HashSet<>();
    for (AbstractInsnNode instruction : method.instructions) {
      if (isDouble(instruction)) {
        lastUse.put(((VarInsnNode) instruction).var, instruction);
      } else if (instruction instanceof VarInsnNode other) {
        others.add(other.var);
      }
    }
    Map<Integer, Integer> slotOf = new HashMap<>();
    TreeSet<Integer> free = new TreeSet<>();
    int next = parameters;
    for (AbstractInsnNode instruction : method.instructions) {
      if (isDouble(instruction) && ((VarInsnNode) instruction).var >= parameters) {
        VarInsnNode access = (VarInsnNode) instruction;
        int variable = access.var;
        Integer slot = slotOf.get(variable);
        if (slot == null) {
          slot = free.pollFirst();
        }
        if (slot == null) {
          while (others.contains(next) || others.contains(next + 1)) {
            next++;
          }
          slot = next;
          next += 2;
        }
        slotOf.put(variable, slot);
        access.var = slot;
        if (instruction.equals(lastUse.get(variable))) {
          free.add(slot);
          slotOf.remove(variable);
        }
      }
    }
  }
}
