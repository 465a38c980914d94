package org.robonewbie.protocol.monitor;

import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.nao.Vector3;

/**
 * A transform in the scene graph, relative to its parent.
 *
 * <p>The transform is a 4 × 4 matrix in column-major order: the columns are the directions of the x, y and z axes, each
 * followed by 0, and the position, followed by 1. Elements have single precision as in SimSpark.
 */
public final class TransformNode implements SceneNode {

    private static final int SIZE = 16;
    private static final int POSITION = 12;

    private final float[] matrix = new float[SIZE];
    private final float[] lastSent = new float[SIZE];
    private final List<SceneNode> children;

    /**
     * Creates a transform.
     *
     * @param matrix the 16 elements; copied
     * @param children the child nodes
     */
    public TransformNode(float[] matrix, List<? extends SceneNode> children) {
        this.children = List.copyOf(children);
        moveTo(matrix, 0);
    }

    /**
     * Creates a transform without rotation.
     *
     * @param x x coordinate of the position in metres
     * @param y y coordinate of the position in metres
     * @param z z coordinate of the position in metres
     * @param children the child nodes
     * @return the transform
     */
    public static TransformNode at(float x, float y, float z, SceneNode... children) {
        return new TransformNode(new float[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1}, List.of(children));
    }

    /**
     * Sets the matrix.
     *
     * @param source array with the 16 elements
     * @param offset index of the first element
     */
    public void moveTo(float[] source, int offset) {
        System.arraycopy(source, offset, matrix, 0, SIZE);
    }

    /**
     * Returns an element of the matrix.
     *
     * @param index index in column-major order, 0 to 15
     * @return the element
     */
    public float element(int index) {
        return matrix[index];
    }

    /** {@return the position in metres} */
    public Vector3 position() {
        return column(POSITION);
    }

    /** {@return the unit vector along the x axis; for a link of a robot, it points to the robot's right} */
    public Vector3 axisX() {
        return column(0);
    }

    /** {@return the unit vector along the y axis; for a link of a robot, it points forward} */
    public Vector3 axisY() {
        return column(4);
    }

    /** {@return the unit vector along the z axis; for a link of a robot, it points up} */
    public Vector3 axisZ() {
        return column(8);
    }

    /** {@return the child nodes} */
    public List<SceneNode> children() {
        return children;
    }

    /** Returns all meshes in this subtree. */
    Stream<MeshNode> meshes() {
        return children.stream().flatMap(child -> {
            if (child instanceof TransformNode transform) {
                return transform.meshes();
            }
            return child instanceof MeshNode mesh ? Stream.of(mesh) : Stream.empty();
        });
    }

    /** Returns the names of all mesh files in this subtree. */
    Stream<String> meshFiles() {
        return meshes().map(MeshNode::form)
                .filter(MeshNode.MeshFile.class::isInstance)
                .map(MeshNode.Form::name);
    }

    /**
     * Returns a copy of this transform with the given children.
     *
     * @param newChildren the child nodes of the copy
     * @return the copy
     */
    public TransformNode with(List<? extends SceneNode> newChildren) {
        return new TransformNode(matrix, newChildren);
    }

    /** Returns whether an element differs by more than the threshold from the matrix that was last sent. */
    boolean hasChangedBeyond(float threshold) {
        for (int i = 0; i < SIZE; i++) {
            if (Math.abs(matrix[i] - lastSent[i]) > threshold || Float.isNaN(matrix[i]) != Float.isNaN(lastSent[i])) {
                return true;
            }
        }
        return false;
    }

    /** Records the current matrix as the one that was last sent. */
    void markSent() {
        System.arraycopy(matrix, 0, lastSent, 0, SIZE);
    }

    private Vector3 column(int start) {
        return new Vector3(matrix[start], matrix[start + 1], matrix[start + 2]);
    }
}
