package org.robonewbie.protocol.monitor;

import java.util.List;
import org.robonewbie.nao.Vector3;

/**
 * A place in the scene, relative to the transform around it.
 *
 * <p>The place is a matrix of 16 numbers, column by column: where the x axis points and a 0, the same for y and z, then the
 * position and a 1. The numbers are of single precision as in SimSpark.
 */
public final class TransformNode implements SceneNode {

    private static final int SIZE = 16;
    private static final int POSITION = 12;

    private final float[] matrix = new float[SIZE];
    private final float[] told = new float[SIZE];
    private final List<SceneNode> children;

    /**
     * Creates a place.
     *
     * @param matrix its 16 numbers, copied
     * @param children what moves with it
     */
    public TransformNode(float[] matrix, List<? extends SceneNode> children) {
        this.children = List.copyOf(children);
        moveTo(matrix, 0);
    }

    /**
     * Creates a place that is not turned.
     *
     * @param x first component of its position in metres
     * @param y second component
     * @param z third component
     * @param children what moves with it
     * @return the place
     */
    public static TransformNode at(float x, float y, float z, SceneNode... children) {
        return new TransformNode(new float[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1}, List.of(children));
    }

    /**
     * Moves the place and all in it.
     *
     * @param source holds the 16 numbers of the new place
     * @param offset index of the first of them
     */
    public void moveTo(float[] source, int offset) {
        System.arraycopy(source, offset, matrix, 0, SIZE);
    }

    /**
     * Reads one number of the place.
     *
     * @param index 0 to 15, column by column
     * @return the number
     */
    public float element(int index) {
        return matrix[index];
    }

    /**
     * Tells the position.
     *
     * @return metres
     */
    public Vector3 position() {
        return column(POSITION);
    }

    /**
     * Tells where the x axis points; on a robot's link to its right.
     *
     * @return a direction of length 1
     */
    public Vector3 axisX() {
        return column(0);
    }

    /**
     * Tells where the y axis points; on a robot's link forward.
     *
     * @return a direction of length 1
     */
    public Vector3 axisY() {
        return column(4);
    }

    /**
     * Tells where the z axis points; on a robot's link up.
     *
     * @return a direction of length 1
     */
    public Vector3 axisZ() {
        return column(8);
    }

    /**
     * Lists what moves with it.
     *
     * @return the nodes inside
     */
    public List<SceneNode> children() {
        return children;
    }

    /**
     * Makes a node at the same place with other children.
     *
     * @param newChildren what moves with the new node
     * @return the new node
     */
    public TransformNode with(List<? extends SceneNode> newChildren) {
        return new TransformNode(matrix, newChildren);
    }

    /** Tells whether a number is farther than the threshold from what was told last. */
    boolean hasMovedBeyond(float threshold) {
        for (int i = 0; i < SIZE; i++) {
            if (Math.abs(matrix[i] - told[i]) > threshold || Float.isNaN(matrix[i]) != Float.isNaN(told[i])) {
                return true;
            }
        }
        return false;
    }

    /** Keeps the present place as the one that was told last. */
    void rememberAsTold() {
        System.arraycopy(matrix, 0, told, 0, SIZE);
    }

    private Vector3 column(int start) {
        return new Vector3(matrix[start], matrix[start + 1], matrix[start + 2]);
    }
}
