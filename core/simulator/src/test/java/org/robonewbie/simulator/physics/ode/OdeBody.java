package org.robonewbie.simulator.physics.ode;

import org.ode4j.ode.DBody;
import org.ode4j.ode.DMass;
import org.ode4j.ode.DWorld;
import org.ode4j.ode.OdeHelper;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.MassDistribution;
import org.robonewbie.simulator.physics.RigidBody;
import org.robonewbie.simulator.physics.RotationMatrix;

/** A body of ODE. */
final class OdeBody implements RigidBody {

    private final DBody body;
    private final MassDistribution nominal;

    OdeBody(DWorld world, MassDistribution mass, Vector3 position) {
        body = OdeHelper.createBody(world);
        nominal = mass;
        setMassFactor(1);
        setPosition(position);
    }

    DBody body() {
        return body;
    }

    @Override
    public Vector3 position() {
        return OdeVectors.from(body.getPosition());
    }

    @Override
    public RotationMatrix rotation() {
        return OdeVectors.from(body.getRotation());
    }

    @Override
    public Vector3 axisY() {
        return rotation().axisY();
    }

    @Override
    public double upwards() {
        return rotation().zz();
    }

    @Override
    public Vector3 directionToLocal(double x, double y, double z) {
        return rotation().inverse().apply(new Vector3(x, y, z));
    }

    @Override
    public Vector3 localAngularVelocity() {
        return rotation().inverse().apply(angularVelocity());
    }

    @Override
    public boolean isWithin(double metres) {
        Vector3 centre = position();
        return Math.abs(centre.x()) < metres && Math.abs(centre.y()) < metres && Math.abs(centre.z()) < metres;
    }

    @Override
    public void addDamping(double linear, double angular) {
        addForce(velocity().times(-linear));
        addTorque(angularVelocity().times(-angular));
    }

    @Override
    public Vector3 velocity() {
        return OdeVectors.from(body.getLinearVel());
    }

    @Override
    public Vector3 angularVelocity() {
        return OdeVectors.from(body.getAngularVel());
    }

    @Override
    public void setPosition(Vector3 position) {
        body.setPosition(position.x(), position.y(), position.z());
    }

    @Override
    public void setRotation(RotationMatrix rotation) {
        body.setRotation(OdeVectors.to(rotation));
    }

    @Override
    public void setVelocity(Vector3 metresPerSecond) {
        body.setLinearVel(metresPerSecond.x(), metresPerSecond.y(), metresPerSecond.z());
    }

    @Override
    public void setAngularVelocity(Vector3 radiansPerSecond) {
        body.setAngularVel(radiansPerSecond.x(), radiansPerSecond.y(), radiansPerSecond.z());
    }

    @Override
    public void addForce(Vector3 newtons) {
        body.addForce(newtons.x(), newtons.y(), newtons.z());
    }

    @Override
    public void addTorque(Vector3 newtonMetres) {
        body.addTorque(newtonMetres.x(), newtonMetres.y(), newtonMetres.z());
    }

    @Override
    public void setMassFactor(double factor) {
        DMass details = OdeHelper.createMass();
        Vector3 inertia = nominal.inertia().times(factor);
        details.setParameters(factor * nominal.massKg(), 0, 0, 0, inertia.x(), inertia.y(), inertia.z(), 0, 0, 0);
        body.setMass(details);
    }

    @Override
    public void setGrip(double factor) {
        throw new UnsupportedOperationException();
    }

    @Override
    public boolean isAsleep() {
        return !body.isEnabled();
    }

    @Override
    public void wake() {
        body.enable();
    }
}
