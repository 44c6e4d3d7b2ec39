// Styles that the build puts into modules as text.
declare module "*.css" {
  const text: string;
  export default text;
}
