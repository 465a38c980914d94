package org.robonewbie.protocol.monitor;

import java.util.List;

/** A surface to draw: a mesh from a file, or one of SimSpark's standard shapes. */
public final class MeshNode implements SceneNode {

    private final Form form;
    private final boolean transparent;
    private final float scaleX;
    private final float scaleY;
    private final float scaleZ;
    private List<String> materials;
    private boolean visible;
    private boolean visibilityIsNews = true;

    /**
     * Creates a surface.
     *
     * @param form its form
     * @param scaleX scale along x
     * @param scaleY scale along y
     * @param scaleZ scale along z
     * @param materials names of its materials; a standard shape has one
     * @param transparent whether it is transparent
     * @param visible whether it is visible
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

    /** The form of a surface. */
    public sealed interface Form {

        /** {@return the form's name in messages: path of a mesh file or name of a standard shape} */
        String name();

        /** {@return the words after the name, such as radius and length} */
        List<String> parameters();
    }

    /**
     * A mesh from a file.
     *
     * @param name path of the file below the data directory, such as {@code models/naohead.obj}
     * @param parameters further words for the loader, mostly none
     */
    public record MeshFile(String name, List<String> parameters) implements Form {}

    /**
     * A box, sphere, capsule or cylinder of size 1.
     *
     * @param name one of {@code StdUnitBox}, {@code StdUnitSphere}, {@code StdCapsule}, {@code StdUnitCylinder}
     * @param parameters radius and length of capsule and cylinder
     */
    public record StandardShape(String name, List<String> parameters) implements Form {}

    /** {@return the form of the surface} */
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

    /** {@return whether it is transparent} */
    public boolean isTransparent() {
        return transparent;
    }

    /** {@return the names of the materials in the order of the mesh file} */
    public List<String> materials() {
        return materials;
    }

    /**
     * Replaces the materials; monitors receive them with the next full message.
     *
     * @param names the new names
     */
    public void setMaterials(List<String> names) {
        materials = List.copyOf(names);
    }

    /** {@return whether it is drawn} */
    public boolean isVisible() {
        return visible;
    }

    /**
     * Sets whether it is visible.
     *
     * @param shown whether it is drawn
     */
    public void setVisible(boolean shown) {
        visibilityIsNews |= visible != shown;
        visible = shown;
    }

    /** Returns once whether the visibility has changed since the last call; true the first time. */
    boolean takeVisibilityNews() {
        boolean news = visibilityIsNews;
        visibilityIsNews = false;
        return news;
    }
}
