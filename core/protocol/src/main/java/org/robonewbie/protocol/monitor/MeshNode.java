package org.robonewbie.protocol.monitor;

import java.util.List;

/** A mesh to draw: either one loaded from a file or one of SimSpark's standard shapes. */
public final class MeshNode implements SceneNode {

    private final Form form;
    private final boolean transparent;
    private final float scaleX;
    private final float scaleY;
    private final float scaleZ;
    private List<String> materials;
    private boolean visible;
    private boolean visibilityChanged = true;

    /**
     * Creates a mesh.
     *
     * @param form the mesh file or standard shape
     * @param scaleX scale along x
     * @param scaleY scale along y
     * @param scaleZ scale along z
     * @param materials names of the materials; a standard shape has one
     * @param transparent whether the mesh is transparent
     * @param visible whether the mesh is visible
     */
    public MeshNode(
            Form form,
            float scaleX,
            float scaleY,
            float scaleZ,
            List<String> materials,
            boolean transparent,
            boolean visible) {
        this.form = form;
        this.scaleX = scaleX;
        this.scaleY = scaleY;
        this.scaleZ = scaleZ;
        this.materials = List.copyOf(materials);
        this.transparent = transparent;
        this.visible = visible;
    }

    /** The shape of a mesh. */
    public sealed interface Form {

        /** {@return the name of the shape in messages: the path of a mesh file or the name of a standard shape} */
        String name();

        /** {@return the arguments after the name, such as radius and length} */
        List<String> parameters();
    }

    /**
     * A mesh from a file.
     *
     * @param name path of the file in the data directory, such as {@code models/naohead.obj}
     * @param parameters further arguments for the loader, usually none
     */
    public record MeshFile(String name, List<String> parameters) implements Form {}

    /**
     * A box, sphere, capsule or cylinder of unit size.
     *
     * @param name one of {@code StdUnitBox}, {@code StdUnitSphere}, {@code StdCapsule}, {@code StdUnitCylinder}
     * @param parameters radius and length of capsule and cylinder
     */
    public record StandardShape(String name, List<String> parameters) implements Form {}

    /** {@return the mesh file or standard shape} */
    public Form form() {
        return form;
    }

    /** {@return the scale along x} */
    public float scaleX() {
        return scaleX;
    }

    /** {@return the scale along y} */
    public float scaleY() {
        return scaleY;
    }

    /** {@return the scale along z} */
    public float scaleZ() {
        return scaleZ;
    }

    /** {@return whether the mesh is transparent} */
    public boolean isTransparent() {
        return transparent;
    }

    /** {@return the names of the materials in the order in which the mesh file uses them} */
    public List<String> materials() {
        return materials;
    }

    /**
     * Replaces the materials. Monitors receive them with the next full message.
     *
     * @param names the new names
     */
    public void setMaterials(List<String> names) {
        materials = List.copyOf(names);
    }

    /** {@return whether the mesh is visible} */
    public boolean isVisible() {
        return visible;
    }

    /**
     * Sets whether the mesh is visible.
     *
     * @param shown whether the mesh is visible
     */
    public void setVisible(boolean shown) {
        visibilityChanged |= visible != shown;
        visible = shown;
    }

    /** Returns whether the visibility has changed since the last call, and resets the flag; true for the first call. */
    boolean takeVisibilityChange() {
        boolean changed = visibilityChanged;
        visibilityChanged = false;
        return changed;
    }
}
