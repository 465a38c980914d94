package org.robonewbie.learning.optimise;

/** The objectives of the framework by name. */
final class NamedObjective {

    private NamedObjective() {}

    static Objective named(String label) {
        return Objective.named(label, NamedObjective.class.getClassLoader());
    }
}
