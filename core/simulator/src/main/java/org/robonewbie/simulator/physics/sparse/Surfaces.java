package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.simulator.physics.Material;

/** All materials of a world, numbered, and how each two of them behave in contact. */
final class Surfaces {

    private final List<Material> materials = new ArrayList<>();
    private final List<List<ContactSurface>> mixed = new ArrayList<>();
    private double grip = 1;

    /** Changes how well all materials hold; the number of a material stays. */
    void setGrip(double factor) {
        if (factor != grip) {
            grip = factor;
            List<Material> known = List.copyOf(materials);
            materials.clear();
            mixed.clear();
            known.forEach(this::numberOf);
        }
    }

    /** Returns the number of a material. */
    int numberOf(Material material) {
        int known = materials.indexOf(material);
        if (known >= 0) {
            return known;
        }
        materials.add(material);
        List<ContactSurface> row = new ArrayList<>();
        for (int i = 0; i < materials.size(); i++) {
            ContactSurface surface = ContactSurface.of(material.mixedWith(materials.get(i)), grip);
            row.add(surface);
            if (i < mixed.size()) {
                mixed.get(i).add(surface);
            }
        }
        mixed.add(row);
        return materials.size() - 1;
    }

    ContactSurface between(int one, int other) {
        return mixed.get(one).get(other);
    }
}
