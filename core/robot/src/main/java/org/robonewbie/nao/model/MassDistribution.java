package org.robonewbie.nao.model;

import org.robonewbie.nao.Vector3;

/**
 * Mass and principal moments of inertia of a body.
 *
 * @param massKg mass in kilograms
 * @param inertia moments about the body's x, y and z axes in kg m²
 */
public record MassDistribution(double massKg, Vector3 inertia) {

    /**
     * Computes the inertia of a homogeneous solid shape (formulas: ODE manual, mass functions).
     *
     * @param shape the shape
     * @param massKg mass in kilograms
     * @return mass and inertia
     */
    public static MassDistribution of(Shape shape, double massKg) {
        if (shape instanceof Shape.Box box) {
            return ofBox(box.size(), massKg);
        }
        if (shape instanceof Shape.Sphere sphere) {
            return ofSphere(sphere.radius(), massKg);
        }
        Shape.Capsule capsule = (Shape.Capsule) shape;
        return ofCapsule(capsule.radius(), capsule.length(), massKg);
    }

    private static MassDistribution ofBox(Vector3 size, double mass) {
        double xx = size.x() * size.x();
        double yy = size.y() * size.y();
        double zz = size.z() * size.z();
        return new MassDistribution(
                mass, new Vector3(mass / 12 * (yy + zz), mass / 12 * (xx + zz), mass / 12 * (xx + yy)));
    }

    private static MassDistribution ofSphere(double radius, double mass) {
        double inertia = 0.4 * mass * radius * radius;
        return new MassDistribution(mass, new Vector3(inertia, inertia, inertia));
    }

    private static MassDistribution ofCapsule(double radius, double length, double mass) {
        double square = radius * radius;
        double cylinderVolume = Math.PI * square * length;
        double capsVolume = 4.0 / 3.0 * Math.PI * square * radius;
        double density = mass / (cylinderVolume + capsVolume);
        double cylinder = density * cylinderVolume;
        double caps = density * capsVolume;
        double across = cylinder * (0.25 * square + length * length / 12)
                + caps * (0.4 * square + 0.375 * radius * length + 0.25 * length * length);
        double along = (cylinder * 0.5 + caps * 0.4) * square;
        return new MassDistribution(mass, new Vector3(across, across, along));
    }
}
