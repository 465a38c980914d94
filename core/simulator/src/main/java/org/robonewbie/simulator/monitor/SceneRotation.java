package org.robonewbie.simulator.monitor;

import org.robonewbie.nao.math.PortableMath;

/**
 * Single-precision transforms of fixed scene nodes, rotated about x, then y, then z. The operations are in SimSpark's
 * order, so that monitors receive values with the same rounding errors.
 */
final class SceneRotation {

    private static final int ROWS = 4;
    private static final int X = 0;
    private static final int Y = 4;
    private static final int Z = 8;
    private static final int POSITION = 12;

    private final float[] matrix;

    private SceneRotation(float degreesX) {
        float cosine = cosine(degreesX);
        float sine = sine(degreesX);
        matrix = new float[] {1, 0, 0, 0, 0, cosine, sine, 0, 0, -sine, cosine, 0, 0, 0, 0, 1};
    }

    /** Returns the 4 × 4 matrix, in column-major order, that combines a position and three rotations. */
    static float[] transform(float x, float y, float z, float degreesX, float degreesY, float degreesZ) {
        SceneRotation rotation = new SceneRotation(degreesX);
        rotation.rotate(Z, X, degreesY);
        rotation.rotate(X, Y, degreesZ);
        rotation.matrix[POSITION] = x;
        rotation.matrix[POSITION + 1] = y;
        rotation.matrix[POSITION + 2] = z;
        return rotation.matrix;
    }

    /** Rotates two columns in their common plane, the first towards the second. */
    private void rotate(int first, int second, float degrees) {
        float cosine = cosine(degrees);
        float sine = sine(degrees);
        for (int row = 0; row < ROWS; row++) {
            float a = matrix[first + row];
            float b = matrix[second + row];
            matrix[first + row] = a * cosine + b * sine;
            matrix[second + row] = b * cosine - a * sine;
        }
    }

    private static float cosine(float degrees) {
        return (float) PortableMath.cos(radians(degrees));
    }

    private static float sine(float degrees) {
        return (float) PortableMath.sin(radians(degrees));
    }

    private static float radians(float degrees) {
        return (float) Math.PI / 180 * degrees;
    }
}
