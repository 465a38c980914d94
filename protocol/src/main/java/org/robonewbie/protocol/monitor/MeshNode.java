package org.robonewbie.protocol.monitor;

import java.util.List;

/** A surface to draw: a mesh from a file, or one of the standard shapes of SimSpark. */
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
     * @param form what it looks like
     * @param scaleX stretches it along x
     * @param scaleY stretches it along y
     * @param scaleZ stretches it along z
     * @param materials names of its materials; a standard shape has one
     * @param transparent whether one can look through it
     * @param visible whether it can be seen
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

    /** What a surface looks like. */
    public sealed interface Form {

        /**
         * Names the form in messages.
         *
         * @return path of a mesh file or name of a standard shape
         */
        String name();

        /**
         * Lists what makes the form special.
         *
         * @return the words after the name, such as radius and length
         */
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

    /**
     * Tells what the surface looks like.
     *
     * @return the form
     */
    public Form form() {
        return form;
    }

    /**
     * Tells how far it is stretched along x.
     *
     * @return the factor
     */
    public float scaleX() {
        return scaleX;
    }

    /**
     * Tells how far it is stretched along y.
     *
     * @return the factor
     */
    public float scaleY() {
        return scaleY;
    }

    /**
     * Tells how far it is stretched along z.
     *
     * @return the factor
     */
    public float scaleZ() {
        return scaleZ;
    }

    /**
     * Tells whether one can look through it.
     *
     * @return whether it is transparent
     */
    public boolean isTransparent() {
        return transparent;
    }

    /**
     * Names the materials.
     *
     * @return the names in the order of the mesh file
     */
    public List<String> materials() {
        return materials;
    }

    /**
     * Gives it other materials; monitors learn of it with the next full message.
     *
     * @param names the new names
     */
    public void setMaterials(List<String> names) {
        materials = List.copyOf(names);
    }

    /**
     * Tells whether it can be seen.
     *
     * @return whether it is drawn
     */
    public boolean isVisible() {
        return visible;
    }

    /**
     * Shows or hides it.
     *
     * @param shown whether it is drawn
     */
    public void setVisible(boolean shown) {
        visibilityIsNews |= visible != shown;
        visible = shown;
    }

    /** Tells once whether the visibility was changed since the last call, and also the first time. */
    boolean takeVisibilityNews() {
        boolean news = visibilityIsNews;
        visibilityIsNews = false;
        return news;
    }
}
