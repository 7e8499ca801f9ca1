package org.mechservice.orb;

import java.lang.reflect.Field;
import org.jacorb.orb.ORB;
import org.jacorb.orb.giop.GIOPConnectionManager;
import org.jacorb.orb.portableInterceptor.ORBInitInfoImpl;
import org.omg.CORBA.INITIALIZE;
import org.omg.CORBA.LocalObject;
import org.omg.PortableInterceptor.ORBInitInfo;
import org.omg.PortableInterceptor.ORBInitializer;

/**
 * Gives an ORB its {@link ConnectionTable}, before anything uses the one it made itself. The ORB
 * has no setting for that; should another version of it keep its table elsewhere, it does not
 * start.
 *
 * <p>Made by the ORB from its properties, hence public.
 */
public final class ConnectionTableInstaller extends LocalObject implements ORBInitializer {
  private static final long serialVersionUID = 1L;

  @Override
  public void pre_init(ORBInitInfo info) {
    ORB orb = ((ORBInitInfoImpl) info).getORB();
    try {
      Field connections = field("giop_connection_manager");
      field("clientConnectionManager")
          .set(
              orb,
              new ConnectionTable(
                  orb, (GIOPConnectionManager) connections.get(orb), orb.getConfiguration()));
    } catch (ReflectiveOperationException | org.jacorb.config.ConfigurationException e) {
      throw (INITIALIZE) new INITIALIZE("this version of the ORB is not known").initCause(e);
    }
  }

  private static Field field(String name) throws NoSuchFieldException {
    Field field = ORB.class.getDeclaredField(name);
    field.setAccessible(true);
    return field;
  }

  @Override
  public void post_init(ORBInitInfo info) {
    // All is done before.
  }
}
