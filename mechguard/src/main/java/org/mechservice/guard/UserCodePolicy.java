package org.mechservice.guard;

/** The place where a host runs user classes. */
public enum UserCodePolicy {
  /** Nowhere: they are neither compiled nor run. */
  REFUSED,
  /** Confined by the operating system; where it cannot confine them, they do not run. */
  CONFINED,
  /** Confined where the operating system can, and otherwise in an ordinary process. */
  UNCONFINED;

  /** Returns whether sources of users may be compiled, which runs nothing of theirs. */
  public boolean compiles() {
    return this != REFUSED;
  }

  /** Returns what happens to them on a machine with a wall, for operators. */
  public String text(Confinement confinement) {
    if (this == REFUSED) {
      return "refused";
    } else if (confinement.stands()) {
      return "confined: " + confinement.text();
    }
    return (this == UNCONFINED ? "unconfined: " : "not run: ") + confinement.text();
  }

  /** Returns whether they run on a machine with a wall. */
  public boolean runsBehind(Confinement confinement) {
    return this == UNCONFINED || (this == CONFINED && confinement.stands());
  }
}
