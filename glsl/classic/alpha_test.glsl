// glAlphaFunc: whether a fragment goes on.

const int NEVER = 0;
const int LESS = 1;
const int EQUAL = 2;
const int LEQUAL = 3;
const int GREATER = 4;
const int NOTEQUAL = 5;
const int GEQUAL = 6;
const int ALWAYS = 7;

uniform int alpha_func;    // ALWAYS where GL_ALPHA_TEST is disabled
uniform float alpha_ref;

bool alpha_test(float alpha) {
    switch (alpha_func) {
        case NEVER: return false;
        case LESS: return alpha < alpha_ref;
        case EQUAL: return alpha == alpha_ref;
        case LEQUAL: return alpha <= alpha_ref;
        case GREATER: return alpha > alpha_ref;
        case NOTEQUAL: return alpha != alpha_ref;
        case GEQUAL: return alpha >= alpha_ref;
    }
    return true;
}
