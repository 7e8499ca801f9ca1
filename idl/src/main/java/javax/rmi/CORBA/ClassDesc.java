package javax.rmi.CORBA;

import java.io.Serializable;

/** Stands in for the class of this name that the JDK dropped in version 11; see {@link Stub}. */
public class ClassDesc implements Serializable {
  private static final long serialVersionUID = 1L;
}
