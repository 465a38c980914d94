package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.simulator.physics.Material;

/** Indexed materials of a world, with the contact surface of each pair of materials. */
final class Surfaces {

    private final List<Material> materials = new ArrayList<>();
    private final List<List<ContactSurface>> surfaces = new ArrayList<>();
    private double grip = 1;

    /** Scales the grip of all materials. Material indices do not change. */
    void setGrip(double factor) {
        if (factor != grip) {
            grip = factor;
            List<Material> previous = List.copyOf(materials);
            materials.clear();
            surfaces.clear();
            previous.forEach(this::indexOf);
        }
    }

    /** Returns the index of a material, adding it if necessary. */
    int indexOf(Material material) {
        int index = materials.indexOf(material);
        if (index >= 0) {
            return index;
        }
        materials.add(material);
        List<ContactSurface> row = new ArrayList<>();
        for (int i = 0; i < materials.size(); i++) {
            ContactSurface surface = ContactSurface.of(material.mixedWith(materials.get(i)), grip);
            row.add(surface);
            if (i < surfaces.size()) {
                surfaces.get(i).add(surface);
            }
        }
        surfaces.add(row);
        return materials.size() - 1;
    }

    ContactSurface between(int one, int other) {
        return surfaces.get(one).get(other);
    }
}
