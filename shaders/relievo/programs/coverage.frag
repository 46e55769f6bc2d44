// Nothing but the depth of the surface: for meshes without a relief, and to ask whether a surface is
// hidden before the relief behind it is searched.
void main() {}
