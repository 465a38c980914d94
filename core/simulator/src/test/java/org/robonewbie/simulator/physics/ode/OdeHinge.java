package org.robonewbie.simulator.physics.ode;

import org.ode4j.ode.DHingeJoint;
import org.ode4j.ode.DJoint.PARAM_N;
import org.ode4j.ode.DWorld;
import org.ode4j.ode.OdeHelper;
import org.robonewbie.simulator.physics.HingeDefinition;
import org.robonewbie.simulator.physics.MotorHinge;

/** A hinge of ODE. */
final class OdeHinge implements MotorHinge {

    private final DHingeJoint joint;

    OdeHinge(DWorld world, OdeBody child, OdeBody parent, HingeDefinition definition) {
        joint = OdeHelper.createHingeJoint(world);
        joint.attach(child.body(), parent.body());
        joint.setAnchor(
                definition.anchor().x(),
                definition.anchor().y(),
                definition.anchor().z());
        joint.setAxis(
                definition.axis().x(), definition.axis().y(), definition.axis().z());
        joint.setParam(PARAM_N.dParamLoStop1, definition.minRadians());
        joint.setParam(PARAM_N.dParamHiStop1, definition.maxRadians());
        joint.setParam(PARAM_N.dParamVel1, 0);
        joint.setParam(PARAM_N.dParamFMax1, definition.maxTorque());
        joint.setParam(PARAM_N.dParamCFM1, HingeDefinition.SOFTNESS);
        joint.setParam(PARAM_N.dParamStopCFM1, HingeDefinition.SOFTNESS);
        joint.setParam(PARAM_N.dParamStopERP1, HingeDefinition.STOP_ERROR_REDUCTION);
        joint.setParam(PARAM_N.dParamBounce1, definition.stopBounce());
        joint.setParam(PARAM_N.dParamFudgeFactor1, HingeDefinition.FUDGE_FACTOR);
    }

    DHingeJoint joint() {
        return joint;
    }

    @Override
    public double radiansPerSecond() {
        return joint.getAngleRate();
    }

    @Override
    public double torque() {
        throw new UnsupportedOperationException();
    }

    @Override
    public void setMaxTorque(double newtonMetres) {
        joint.setParam(PARAM_N.dParamFMax1, newtonMetres);
    }

    @Override
    public double angleRadians() {
        return joint.getAngle();
    }

    @Override
    public void setSpeed(double radiansPerSecond) {
        joint.setParam(PARAM_N.dParamVel1, radiansPerSecond);
    }
}
