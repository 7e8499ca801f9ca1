package org.mechservice.mechml;

import java.nio.charset.StandardCharsets;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * The text of a small model, to be varied:
 *
 * <pre>
 *   Ground (root) --- j --- link
 * </pre>
 */
public record ModelText(
    String units,
    String ground,
    String link,
    String type,
    String body1,
    String body2,
    String inipos,
    String jointVal,
    String simulation) {

  /** A body on a joint of a type about x, all at zero. */
  public static ModelText of(String type) {
    return new ModelText(
        "massUnits='kg' lengthUnits='m'",
        "<point name='p' x='0' y='0' z='0'/><vector name='u' vx='1' vy='0' vz='0'/>",
        "<point name='p' x='0' y='0' z='0'/><vector name='u' vx='1' vy='0' vz='0'/>",
        type,
        "name='Ground' point='p' vector='u'",
        "name='link' point='p' vector='u'",
        "",
        "",
        "<timeSet tini='0' tend='1' tstep='0.1'/><integrator name='DE' relTol='1e-5'"
            + " absTol='1e-5'/>");
  }

  public ModelText withUnits(String text) {
    return new ModelText(text, ground, link, type, body1, body2, inipos, jointVal, simulation);
  }

  public ModelText withGround(String text) {
    return new ModelText(units, text, link, type, body1, body2, inipos, jointVal, simulation);
  }

  public ModelText withLink(String text) {
    return new ModelText(units, ground, text, type, body1, body2, inipos, jointVal, simulation);
  }

  public ModelText withEnds(String first, String second) {
    return new ModelText(units, ground, link, type, first, second, inipos, jointVal, simulation);
  }

  public ModelText withInipos(String text) {
    return new ModelText(units, ground, link, type, body1, body2, text, jointVal, simulation);
  }

  public ModelText withJointVal(String text) {
    return new ModelText(units, ground, link, type, body1, body2, inipos, text, simulation);
  }

  public ModelText withSimulation(String text) {
    return new ModelText(units, ground, link, type, body1, body2, inipos, jointVal, text);
  }

  /** Returns the file. */
  public String text() {
    return """
    <MechML>
      <MBSsimulation><dynamic>%s</dynamic></MBSsimulation>
      <MBSmodel name='Link' %s>
        <Bodies><body name='Ground'>%s</body><body name='link'>%s</body></Bodies>
        <Joints><joint name='j' type='%s'><body1 %s/><body2 %s/></joint></Joints>
        <topology><root name='Ground'>%s</root><relCoorVals>%s</relCoorVals></topology>
      </MBSmodel>
    </MechML>
    """
        .formatted(simulation, units, ground, link, type, body1, body2, inipos, jointVal);
  }

  /** Returns the model read from the file. */
  public MechmlModel read() throws MechmlException {
    return MechmlReader.read("model.xml", text().getBytes(StandardCharsets.UTF_8));
  }

  public Mechanism mechanism() throws MechmlException {
    return read().mechanism();
  }

  /** Returns the only joint. */
  public Joint joint() throws MechmlException {
    return mechanism().joints().get(0);
  }
}
