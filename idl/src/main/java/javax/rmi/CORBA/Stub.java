package javax.rmi.CORBA;

import java.io.Serializable;
import org.omg.CORBA_2_3.portable.ObjectImpl;

/**
 * Stands in for the class of this name that the JDK dropped in version 11: JacORB needs it to load
 * when it makes an object reference, and needs nothing of it. Remote Java objects by value (RMI
 * over IIOP) are thereby unavailable, which is wanted.
 */
public abstract class Stub extends ObjectImpl implements Serializable {
  private static final long serialVersionUID = 1L;
}
