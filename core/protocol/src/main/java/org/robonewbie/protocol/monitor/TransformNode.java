package org.robonewbie.protocol.monitor;

import java.util.List;
import org.robonewbie.nao.Vector3;

/**
 * A transform in the scene, relative to the one around it.
 *
 * <p>It is a matrix of 16 numbers in column-major order: the direction of the x axis and a 0, the same for y and z, then the
 * position and a 1. The numbers are single-precision as in SimSpark.
 */
public final class TransformNode implements SceneNode {

    private static final int SIZE = 16;
    private static final int POSITION = 12;

    private final float[] matrix = new float[SIZE];
    private final float[] told = new float[SIZE];
    private final List<SceneNode> children;

    /**
     * Creates a transform.
     *
     * @param matrix its 16 numbers, copied
     * @param children the nodes that move with it
     */
    public TransformNode(float[] matrix, List<? extends SceneNode> children) {
        this.children = List.copyOf(children);
        moveTo(matrix, 0);
    }

    /**
     * Creates a transform without rotation.
     *
     * @param x first component of its position in metres
     * @param y second component
     * @param z third component
     * @param children the nodes that move with it
     * @return the transform
     */
    public static TransformNode at(float x, float y, float z, SceneNode... children) {
        return new TransformNode(new float[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1}, List.of(children));
    }

    /**
     * Sets the transform.
     *
     * @param source holds the 16 numbers of the new transform
     * @param offset index of the first of them
     */
    public void moveTo(float[] source, int offset) {
        System.arraycopy(source, offset, matrix, 0, SIZE);
    }

    /**
     * Returns one element of the matrix.
     *
     * @param index 0 to 15, column by column
     * @return the element
     */
    public float element(int index) {
        return matrix[index];
    }

    /** {@return the position in metres} */
    public Vector3 position() {
        return column(POSITION);
    }

    /** {@return the direction of the x axis, of length 1; on a robot's link it points to its right} */
    public Vector3 axisX() {
        return column(0);
    }

    /** {@return the direction of the y axis, of length 1; on a robot's link it points forward} */
    public Vector3 axisY() {
        return column(4);
    }

    /** {@return the direction of the z axis, of length 1; on a robot's link it points up} */
    public Vector3 axisZ() {
        return column(8);
    }

    /** {@return the nodes that move with it} */
    public List<SceneNode> children() {
        return children;
    }

    /**
     * Returns a copy of this transform with other children.
     *
     * @param newChildren the nodes that move with the new transform
     * @return the new transform
     */
    public TransformNode with(List<? extends SceneNode> newChildren) {
        return new TransformNode(matrix, newChildren);
    }

    /** Whether an element differs by more than the threshold from what was last sent. */
    boolean hasMovedBeyond(float threshold) {
        for (int i = 0; i < SIZE; i++) {
            if (Math.abs(matrix[i] - told[i]) > threshold || Float.isNaN(matrix[i]) != Float.isNaN(told[i])) {
                return true;
            }
        }
        return false;
    }

    /** Remembers the present transform as the one that was last sent. */
    void rememberAsTold() {
        System.arraycopy(matrix, 0, told, 0, SIZE);
    }

    private Vector3 column(int start) {
        return new Vector3(matrix[start], matrix[start + 1], matrix[start + 2]);
    }
}
